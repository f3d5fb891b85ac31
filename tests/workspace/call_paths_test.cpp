//! Which calls lead where, which close a cycle, and how deep they go.
#include "analyzer/program/call_kinds.hpp"
#include "tests/support/analysed.hpp"

#include <algorithm>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint {
namespace {

using test::program;
using testing::ElementsAre;
using testing::IsEmpty;

/// 1-based lines of calls.
std::vector<std::uint32_t> lines_of(const Workspace& workspace, const std::vector<Caller>& calls) {
    std::vector<std::uint32_t> lines;
    for (const Caller& call : calls)
        lines.push_back(test::line_of_effect(workspace.programs()[call.program], call.effect));
    return lines;
}

std::vector<std::uint32_t> path(const Workspace& workspace, std::string_view from, std::string_view to) {
    return lines_of(workspace, program(workspace, from).path_to(program(workspace, to).index()).calls);
}

TEST(CallPaths, AreTheShortest) {
    // Over O2 and O3 to O4, or over O5; O6 calls O1.
    const auto workspace = test::analyse_fanuc("O1\nM98P2\nM98P5\nM30\n"
                                               "O2\nM98P3\nM99\n"
                                               "O3\nM98P4\nM99\n"
                                               "O4\nM99\n"
                                               "O5\nM98P4\nM99\n"
                                               "O6\nM98P1\nM30\n");
    EXPECT_THAT(path(*workspace, "O1", "O3"), ElementsAre(2, 6));
    EXPECT_THAT(path(*workspace, "O1", "O4"), ElementsAre(3, 14));
    EXPECT_THAT(path(*workspace, "O6", "O4"), ElementsAre(17, 3, 14));
    EXPECT_THAT(path(*workspace, "O1", "O6"), IsEmpty());
    EXPECT_THAT(path(*workspace, "O1", "O1"), IsEmpty());
    EXPECT_THAT(path(*workspace, "O4", "O1"), IsEmpty());
}

TEST(CallPaths, DoNotLeadThroughUnknownPrograms) {
    const auto workspace = test::analyse_fanuc("O1\nM99\nO2\nM98P77\nM98P3\nM98P#1\nM30\nO3\nM99\n");
    EXPECT_THAT(path(*workspace, "O2", "O1"), IsEmpty());
    EXPECT_THAT(path(*workspace, "O2", "O3"), ElementsAre(5));
}

TEST(CallPaths, GoThroughCycles) {
    const auto workspace =
        test::analyse_fanuc("O1\nM98P1\nM98P2\nM30\nO2\nM98P3\nM99\nO3\nM98P2\nM98P4\nM99\nO4\nM99\n");
    EXPECT_THAT(path(*workspace, "O1", "O4"), ElementsAre(3, 6, 10));
    EXPECT_THAT(path(*workspace, "O3", "O2"), ElementsAre(9));
    EXPECT_THAT(path(*workspace, "O2", "O3"), ElementsAre(6));
}

TEST(CallPaths, OfManyCallsAreTheFirstAndTheLastOnes) {
    std::string text;
    for (int number = 1; number < 20; ++number)
        text += "O" + std::to_string(number) + "\nM98P" + std::to_string(number + 1) + "\nM99\n";
    const auto workspace = test::analyse_fanuc(text + "O20\nM99\n");
    EXPECT_THAT(path(*workspace, "O1", "O9"), ElementsAre(2, 5, 8, 11, 14, 17, 20, 23));
    EXPECT_THAT(path(*workspace, "O1", "O10"), ElementsAre(2, 5, 8, 11, 17, 20, 23, 26));
    EXPECT_THAT(path(*workspace, "O1", "O5"), ElementsAre(2, 5, 8, 11)); // after a search that went further
    const CallPath whole = program(*workspace, "O2").path_to(program(*workspace, "O20").index());
    EXPECT_EQ(whole.length, 18U);
    EXPECT_THAT(lines_of(*workspace, whole.calls), ElementsAre(5, 8, 11, 14, 47, 50, 53, 56));
}

TEST(CallPaths, AreFoundBehindManyCallsOfOneProgram) {
    std::string text = "O1\n";
    for (int i = 0; i < 1001; ++i) text += "M98P2\n";
    const auto workspace = test::analyse_fanuc(text + "M30\nO2\nM98P3\nM99\nO3\nM99\n");
    EXPECT_THAT(path(*workspace, "O1", "O3"), ElementsAre(2, 1005));
}

TEST(CallSites, AreFoundByTheirEffects) {
    const auto workspace = test::analyse_fanuc("O1\nM98P2\n#1=1\nG65P2A1.\nM98P77\nM30\nO2\nM99\n");
    const ProgramAnalysis& main = program(*workspace, "O1");
    ASSERT_EQ(main.calls().size(), 3U);
    for (EffectId id = 0; id < main.program().effects.size(); ++id) {
        const CallSite* site = main.call_at(id);
        EXPECT_EQ(site != nullptr, std::holds_alternative<Call>(main.program().effects[id].what));
        if (site != nullptr) {
            EXPECT_EQ(site->effect, id);
        }
    }
    EXPECT_EQ(main.call_at(1000), nullptr);
    EXPECT_EQ(main.calls()[1].target, program(*workspace, "O2").index());
    EXPECT_FALSE(main.calls()[2].target);
    EXPECT_EQ(main.calls()[2].candidates, 0U);
}

/// Lines of the calls that close a cycle, in all programs.
std::vector<std::uint32_t> closing_calls(const Workspace& workspace) {
    std::vector<std::uint32_t> lines;
    for (const ProgramAnalysis& analysis : workspace.programs())
        for (const CallSite& site : analysis.calls())
            if (site.closes_cycle) lines.push_back(test::line_of_effect(analysis, site.effect));
    return lines;
}

std::vector<std::uint32_t> calls_in_cycles(const Workspace& workspace) {
    std::vector<std::uint32_t> lines;
    for (const ProgramAnalysis& analysis : workspace.programs())
        for (const CallSite& site : analysis.calls())
            if (site.in_cycle) lines.push_back(test::line_of_effect(analysis, site.effect));
    return lines;
}

TEST(Cycles, AreClosedByTheCallThatLeadsBack) {
    const auto workspace = test::analyse_fanuc("O1\nM98P2\nM30\nO2\nM98P3\nM99\nO3\nM98P2\nM99\n");
    EXPECT_THAT(closing_calls(*workspace), ElementsAre(8));
    EXPECT_THAT(calls_in_cycles(*workspace), ElementsAre(5, 8));
}

TEST(Cycles, AreEnteredFromTheProgramThatNothingCalls) {
    // The last program begins, with O2: there it is O1 that calls back.
    const auto workspace = test::analyse_fanuc("O1\nM98P2\nM99\nO2\nM98P1\nM99\nO3\nM98P2\nM30\n");
    EXPECT_THAT(closing_calls(*workspace), ElementsAre(2));
    // With no such program the first one begins.
    EXPECT_THAT(closing_calls(*test::analyse_fanuc("O1\nM98P2\nM99\nO2\nM98P1\nM99\n")), ElementsAre(5));
}

TEST(Cycles, OfOneProgramAreCyclesToo) {
    const auto workspace = test::analyse_fanuc("O1\nM98P2\nM98P1\nM30\nO2\nM99\n");
    EXPECT_THAT(closing_calls(*workspace), ElementsAre(3));
    EXPECT_THAT(calls_in_cycles(*workspace), ElementsAre(3));
    EXPECT_TRUE(program(*workspace, "O1").is_recursive());
    EXPECT_FALSE(program(*workspace, "O2").is_recursive());
}

TEST(Cycles, AreNotMadeByTwoCallsOfOneProgram) {
    const auto workspace =
        test::analyse_fanuc("O1\nM98P2\nM98P3\nM30\nO2\nM98P4\nM99\nO3\nM98P4\nM99\nO4\nM99\n");
    EXPECT_THAT(closing_calls(*workspace), IsEmpty());
    EXPECT_THAT(calls_in_cycles(*workspace), IsEmpty());
}

TEST(Depth, CountsMacrosAndSubprogramsApart) {
    const auto workspace =
        test::analyse_fanuc("O1\nG65P2\nM98P4\nM30\nO2\nM98P3\nM99\nO3\nG65P4\nM99\nO4\nM99\n");
    const CallDepth main = program(*workspace, "O1").depth(), last = program(*workspace, "O4").depth();
    EXPECT_EQ(main.macro, 0);
    EXPECT_EQ(main.subprogram, 0);
    EXPECT_EQ(program(*workspace, "O2").depth().macro, 1);
    EXPECT_EQ(program(*workspace, "O2").depth().subprogram, 0);
    EXPECT_EQ(program(*workspace, "O3").depth().macro, 1);
    EXPECT_EQ(program(*workspace, "O3").depth().subprogram, 1);
    EXPECT_EQ(last.macro, 2);
    EXPECT_EQ(last.subprogram, 1);
    EXPECT_THAT(lines_of(*workspace, program(*workspace, "O4").chain_to(NestingLimit::macro)),
                ElementsAre(2, 6, 9));
    EXPECT_THAT(program(*workspace, "O1").chain_to(NestingLimit::macro), IsEmpty());
}

TEST(Depth, IsThatOfTheLongestChainWhereverItStands) {
    const auto workspace =
        test::analyse_fanuc("O1\nM98P4\nM98P2\nM98P4\nM30\nO2\nM98P3\nM99\nO3\nM98P4\nM99\n"
                            "O4\nM99\n");
    EXPECT_EQ(program(*workspace, "O4").depth().subprogram, 3);
    EXPECT_THAT(lines_of(*workspace, program(*workspace, "O4").chain_to(NestingLimit::subprogram)),
                ElementsAre(3, 7, 10));
}

TEST(Depth, DoesNotCountCallsWithinACycle) {
    const auto workspace =
        test::analyse_fanuc("O1\nM98P2\nM30\nO2\nM98P3\nM98P4\nM99\nO3\nM98P2\nM99\nO4\nM99\n");
    EXPECT_EQ(program(*workspace, "O2").depth().subprogram, 1);
    EXPECT_EQ(program(*workspace, "O4").depth().subprogram, 2);
}

TEST(Started, ByHandIsWhatNothingCallsAndWhatDoesNotReturn) {
    const auto workspace = test::analyse_fanuc("O1\nM98P2\nM30\nO2\nM30\nO3\nM99\n");
    EXPECT_TRUE(program(*workspace, "O1").is_main());
    EXPECT_FALSE(program(*workspace, "O2").is_main());
    EXPECT_FALSE(program(*workspace, "O3").is_main());
}

TEST(Macros, HaveLocalsOfTheirOwn) {
    const auto workspace = test::analyse_fanuc("O1\n#24=1\nG0X#24\nG65P2\nM98P3\nM30\n"
                                               "O2\nM99\nO3\nG0X#24\nM99\nO4\nG0X#24\nM99\n"
                                               "O5\n#24=1\nG0X#24\nM99\n");
    EXPECT_FALSE(program(*workspace, "O1").is_macro());
    EXPECT_TRUE(program(*workspace, "O2").is_macro());
    EXPECT_FALSE(program(*workspace, "O3").is_macro()); // those of the program that calls it
    EXPECT_TRUE(program(*workspace, "O4").is_macro());  // nothing calls it, and it asks for X
    EXPECT_FALSE(program(*workspace, "O5").is_macro()); // which it has set itself
}

} // namespace
} // namespace maclint
