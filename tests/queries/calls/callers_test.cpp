//! Who calls a program, and with what.
#include "analyzer/program/call_kinds.hpp"
#include "analyzer/queries/calls/call_depth.hpp"
#include "analyzer/queries/calls/callers.hpp"
#include "tests/support/analysed.hpp"

#include <memory>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint::queries {
namespace {

/// The folder and name of the program that `caller` stands in; empty when there is none.
std::string name_of(const ProgramAnalysis& analysis, const Caller* caller) {
    return caller == nullptr ? std::string() : calling_program(analysis, *caller).program().name;
}

std::string reached_caller(const std::vector<test::NamedText>& files, bool complete) {
    const auto workspace = test::analyse_files(files, {.complete = complete, .jobs = 1});
    const ProgramAnalysis& callee = test::program(*workspace, "O2");
    return name_of(callee, find_reached_caller(callee));
}

TEST(ReachedCallers, AreOtherProgramsThatComeToTheCall) {
    EXPECT_EQ(reached_caller({{"a/x.nc", "O1\nM98P2\nM30\nO2\nX1.\nM99\n"}}, false), "O1");
    EXPECT_EQ(reached_caller({{"a/x.nc", "O1\nM30\nM98P2\nO2\nX1.\nM99\n"}}, false), "");
    EXPECT_EQ(reached_caller({{"a/x.nc", "O1\nM30\nO2\nM98P2\nM99\n"}}, false), "");
}

TEST(ReachedCallers, AreOfOneFolderUnlessAllProgramsAreKnown) {
    const std::vector<test::NamedText> beside{{"a/x.nc", "O1\nM98P2\nM30\n"}, {"b/y.nc", "O2\nX1.\nM99\n"}};
    EXPECT_EQ(reached_caller(beside, false), "");
    EXPECT_EQ(reached_caller(beside, true), "O1");
    EXPECT_EQ(reached_caller({{"a/x.nc", "O1\nM98P2\nM30\n"}, {"a/b/y.nc", "O2\nX1.\nM99\n"}}, false), "O1");
}

TEST(CallersWithout, LeaveAnArgumentOut) {
    const auto workspace = test::analyse_fanuc("O1\nG65P9A1.B2.\nM30\nO2\nG65P9A1.\nM30\nO9\nX#1Y#2\nM99\n");
    const ProgramAnalysis& callee = test::program(*workspace, "O9");
    EXPECT_EQ(name_of(callee, find_caller_without(callee, {0, 1})), "");
    EXPECT_EQ(name_of(callee, find_caller_without(callee, {0, 2})), "O2");
    const ProgramAnalysis& uncalled = test::program(*workspace, "O1");
    EXPECT_EQ(find_caller_without(uncalled, {0, 1}), nullptr);
}

TEST(CallersLacking, HaveNoBlockOfThatNumber) {
    const auto workspace = test::analyse_fanuc("O1\nM98P9\nN5M30\nO2\nM98P9\nM30\nO9\nX1.\nM99P5\n");
    const ProgramAnalysis& callee = test::program(*workspace, "O9");
    EXPECT_EQ(name_of(callee, find_caller_lacking(callee, first_callers(callee), 5)), "O2");
    const auto recursive = test::analyse_fanuc("O9\nM98P9\nX1.\nM99P5\n");
    const ProgramAnalysis& itself = recursive->programs().front();
    EXPECT_EQ(find_caller_lacking(itself, first_callers(itself), 5), nullptr);
}

TEST(Uncalled, AreProgramsOfACompleteFolderThatNothingCanMean) {
    const auto uncalled = [](const std::string& caller, bool complete) {
        const auto workspace =
            test::analyse_files({{"a.nc", caller + "O2\nX1.\nM99\n"}}, {.complete = complete, .jobs = 1});
        return is_called_by_nobody(test::program(*workspace, "O2"));
    };
    EXPECT_TRUE(uncalled("O1\nM30\n", true));
    EXPECT_FALSE(uncalled("O1\nM30\n", false));
    EXPECT_FALSE(uncalled("O1\nM98P2\nM30\n", true));
}

TEST(CalledPrograms, AreNoneOfCallsThatMeanNothingKnown) {
    const auto workspace = test::analyse_fanuc("O1\nM98P2\nM98P77\nM30\nO2\nM99\n");
    const ProgramAnalysis& main = test::program(*workspace, "O1");
    ASSERT_EQ(main.calls().size(), 2U);
    EXPECT_EQ(called_program(main, main.calls()[0]), &test::program(*workspace, "O2"));
    EXPECT_EQ(called_program(main, main.calls()[1]), nullptr);
}

TEST(CallsBeyond, AreThoseOfTheFirstLevelTooDeep) {
    const auto workspace = test::analyse_fanuc("O1\nM98P2\nM30\nO2\nM98P3\nM99\nO3\nM98P4\nM99\nO4\nM99\n");
    const auto beyond = [&](const char* name, int limit) {
        return calls_beyond(test::program(*workspace, name), NestingLimit::subprogram, limit).size();
    };
    EXPECT_EQ(beyond("O2", 1), 1U);
    EXPECT_EQ(beyond("O3", 1), 0U);
    EXPECT_EQ(beyond("O1", 1), 0U);
    EXPECT_EQ(calls_beyond(test::program(*workspace, "O2"), NestingLimit::macro, 1).size(), 0U);
}

} // namespace
} // namespace maclint::queries
