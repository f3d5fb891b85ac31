//! What the solver knows at a word that reads a variable, or at a program's end: each worked out by hand.
#include "analyzer/dataflow/facts/comparison.hpp"
#include "analyzer/dataflow/facts/exit_state.hpp"
#include "analyzer/dataflow/facts/read.hpp"
#include "analyzer/dataflow/solver/state_domain.hpp"
#include "analyzer/program/tables.hpp"
#include "tests/dataflow/expect.hpp"
#include "tests/support/analysed.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include <gtest/gtest.h>

namespace maclint {
namespace {

using dataflow::Vacancy;
using dataflow::Value;
using test::last_read;

using dataflow::infinity;

/// What a modal group can be at the only exit that is reached.
dataflow::ModalValue at_exit(const ProgramAnalysis& analysis, ModalRole role) {
    const auto& exits = analysis.facts().all<dataflow::ExitState>();
    EXPECT_EQ(exits.size(), 1U);
    return analysis.data().modal(exits.front(), *analysis.control().group_with(role));
}

TEST(Solver, WinsBackTheBoundThatWideningGaveAway) {
    // No number of a comparison stops the widening of #1: what #2 holds, narrowing finds.
    const Value after = last_read("#1=0\n#2=10\nN1#1=#1+1\nIF[#1LT#2]GOTO1\nX#1\nM30\n");
    EXPECT_EQ(after.low, 10);
    EXPECT_EQ(after.high, 10);
}

TEST(Solver, WidensAtHeadsOfLoopsEarlyAndElsewhereLate) {
    EXPECT_FALSE(dataflow::StateDomain::widens(true, 1));
    EXPECT_TRUE(dataflow::StateDomain::widens(true, 2));
    EXPECT_FALSE(dataflow::StateDomain::widens(false, 11));
    EXPECT_TRUE(dataflow::StateDomain::widens(false, 12));
}

TEST(Solver, WhatAGroupCanBeIsSortedWhicheverWordCameFirst) {
    // #3 is known earlier than #4, and its word stands later: it is ignored on one of the paths.
    const auto workspace = test::analyse_fanuc("O9001\nIF[#7EQ1]GOTO1\n#3=#0\nGOTO2\nN1#3=5\n"
                                               "N2#4=#8+#9\nF#4\nF#3\nM30\n");
    const dataflow::ModalValue feed = at_exit(workspace->programs().front(), ModalRole::feed);
    EXPECT_EQ(feed.parts.size(), 2U);
    EXPECT_TRUE(std::ranges::is_sorted(feed.parts));
}

TEST(Solver, OfManyPathsThatMeetEachCounts) {
    constexpr int paths = 101;
    std::string text;
    for (int i = 1; i <= paths; ++i)
        text += "#1=" + std::to_string(i) + "\nIF[#500EQ" + std::to_string(i) + "]GOTO9\n";
    const Value met = last_read(text + "#1=50\nN9X#1\nM30\n");
    EXPECT_EQ(met.low, 1);
    EXPECT_EQ(met.high, paths);
    EXPECT_TRUE(met.integer);
}

TEST(Solver, FactsAreInTheOrderOfTheText) {
    // The loop settles before what is written inside of it and leads out.
    const auto workspace =
        test::analyse_fanuc("O0001\n#1=0\nN1#1=#1+1\nIF[#500EQ1]GOTO5\nGOTO6\nN5#2=#1\nGOTO9\n"
                            "N6IF[#1LT5]GOTO1\nN9X#1\nM30\n");
    const ProgramAnalysis& analysis = workspace->programs().front();
    EXPECT_TRUE(std::ranges::is_sorted(analysis.facts().all<dataflow::Read>(), {}, &dataflow::Read::node));
    const auto& reads = analysis.facts().all<dataflow::Read>();
    const auto copied = std::ranges::find(reads, dataflow::Use::copy, &dataflow::Read::use);
    ASSERT_NE(copied, reads.end());
    EXPECT_EQ(copied->value.low, 1); // #2=#1
    EXPECT_EQ(copied->value.high, 5);
}

TEST(Solver, AnUnknownCallMayChangeCommonsAndModalGroupsAndNotTheCallersLocals) {
    EXPECT_FALSE(last_read("#100=5\nG65 P77\nX#100\nM30\n").constant());
    EXPECT_EQ(last_read("#100=5\nG65 P77\nX#100\nM30\n").vacancy, Vacancy::unknown);
    EXPECT_FALSE(last_read("#500=5\nG65 P77\nX#500\nM30\n").constant());
    EXPECT_EQ(last_read("#1=5\nG65 P77\nX#1\nM30\n").constant(), 5);
    EXPECT_FALSE(last_read("#1=5\nM98 P77\nX#1\nM30\n").constant()); // which shares them
    const auto workspace = test::analyse_fanuc("O0001\nG90 G40\nG65 P77\nM30\n");
    EXPECT_TRUE(at_exit(workspace->programs().front(), ModalRole::distance).unknown);
    EXPECT_TRUE(at_exit(workspace->programs().front(), ModalRole::cutter_compensation).unknown);
}

TEST(Solver, WhatOnePathDoesNotKnowNobodyKnowsWherePathsMeet) {
    for (const std::string branches : {"IF[#500EQ1]GOTO1\nG65 P77\nGOTO2\nN1G91\n",    // unknown first
                                       "IF[#500EQ1]GOTO1\nG91\nGOTO2\nN1G65 P77\n"}) { // and last
        const auto workspace = test::analyse_fanuc("O0001\nG90\n" + branches + "N2M30\n");
        const auto& distance = at_exit(workspace->programs().front(), ModalRole::distance);
        EXPECT_TRUE(distance.unknown) << branches;
        EXPECT_FALSE(distance.parts.empty()) << branches;
    }
}

TEST(Solver, AStoreThroughARangeOfIndexesReachesItsFirstAndItsLast) {
    // #1000 is an input: 0 or 1.
    const auto value_of = [](const std::string& variable) {
        return last_read("#100=5\n#101=6\n#102=7\n#103=8\n#[101+#1000]=9\nX" + variable + "\nM30\n");
    };
    EXPECT_EQ(value_of("#100").constant(), 5);
    EXPECT_FALSE(value_of("#101").constant());
    EXPECT_FALSE(value_of("#102").constant());
    EXPECT_EQ(value_of("#103").constant(), 8);
}

TEST(Solver, AStoreThroughAFractionReachesTheVariableThatItIsRoundedTo) {
    // #1000 is 0 or 1, and 0.5 means #1.
    const auto value_of = [](const std::string& variable) {
        return last_read("#1=5\n#2=6\n#[#1000/2]=9\nX" + variable + "\nM30\n");
    };
    EXPECT_FALSE(value_of("#1").constant());
    EXPECT_EQ(value_of("#2").constant(), 6);
}

TEST(Solver, AStoreThroughAnIndexOfAnySizeReachesAllThatItCan) {
    const auto value_of = [](const std::string& variable) {
        return last_read("#1=5\n#100=5\n#500=5\n#[100+ABS[#501]]=9\nX" + variable + "\nM30\n");
    };
    EXPECT_EQ(value_of("#1").constant(), 5);
    EXPECT_FALSE(value_of("#100").constant());
    EXPECT_FALSE(value_of("#500").constant());
}

TEST(Solver, ACallThatMayNotRunMayChangeNothing) {
    const auto after = [](const std::string& call) {
        const auto workspace = test::analyse_files(
            {{"O1.nc", "O0001\n#100=1\n" + call + "\nX#100\nM30\n"}, {"O2.nc", "O0002\n#100=5\nM99\n"}},
            {.complete = true, .jobs = 1});
        return last_read(workspace->programs().front());
    };
    EXPECT_EQ(after("G65 P2").low, 5);
    EXPECT_EQ(after("G65 P2 L3").low, 5);
    EXPECT_EQ(after("G65 P2 L0").low, 1);
    EXPECT_EQ(after("G65 P2 L0").high, 5);
}

TEST(Solver, AWordWithAVariableThatMayBeVacantMayKeepWhatWasInForce) {
    // F100, or what #500 holds: nobody can say that the feed is #500.
    const auto workspace = test::analyse_fanuc("O0001\nF100\nF#500\nIF[#4109EQ#500]GOTO1\nN1M30\n");
    const auto& comparison = workspace->programs().front().facts().all<dataflow::Comparison>().front();
    EXPECT_TRUE(comparison.truth.can_hold);
    EXPECT_TRUE(comparison.truth.can_fail);
}

bool may_be(const ProgramAnalysis& analysis, const dataflow::ModalValue& value, double code) {
    return value.unknown || std::ranges::any_of(value.parts, [&](const dataflow::ModalPart& part) {
               return analysis.data().table().number_of(part.symbol) == code;
           });
}

TEST(Solver, AModalCallRunsItsProgramAfterTheCodesOfTheMove) {
    const auto workspace =
        test::analyse_files({{"O1.nc", "O0001\nG66 P2\nG91 X1\nG67\nM30\n"}, {"O2.nc", "O0002\nG90\nM99\n"}},
                            {.complete = true, .jobs = 1});
    const ProgramAnalysis& main = workspace->programs().front();
    EXPECT_TRUE(may_be(main, at_exit(main, ModalRole::distance), 90));
}

TEST(Solver, AModalCallThatACalledProgramLeavesInForceRunsAnything) {
    const auto after = [](const std::string& left) {
        const auto workspace = test::analyse_files({{"O1.nc", "O0001\n#100=1\nG65 P2\nX1\nX#100\nM30\n"},
                                                    {"O2.nc", "O0002\n" + left + "M99\n"},
                                                    {"O3.nc", "O0003\n#100=5\nM99\n"}},
                                                   {.complete = true, .jobs = 1});
        return last_read(workspace->programs().front()).constant();
    };
    EXPECT_EQ(after("G66 P3\n"), std::nullopt);
    EXPECT_EQ(after("G66 P3\nG67\n"), 1);
    EXPECT_EQ(after(""), 1);
}

TEST(Solver, AJumpToABlockThatMayBeSkippedGoesOnAfterIt) {
    const Value value = last_read("#1=1\nGOTO5\n/N5#1=2\nX#1\nM30\n");
    EXPECT_EQ(value.low, 1);
    EXPECT_EQ(value.high, 2);
}

TEST(Solver, AProgramThatOnlyAsksForAVariableDoesNotChangeIt) {
    const auto after = [](const std::string& called) {
        const auto workspace = test::analyse_files(
            {{"O1.nc", "O0001\n#500=5\n#501=6\nG65 P2\nX#500\nX#501\nM30\n"}, {"O2.nc", "O0002\n" + called}},
            {.complete = true, .jobs = 1});
        const auto& reads = workspace->programs().front().facts().all<dataflow::Read>();
        return std::pair(reads[reads.size() - 2].value.constant(), reads.back().value.constant());
    };
    using Constants = std::pair<std::optional<double>, std::optional<double>>;
    const std::string asks = "IF[#500EQ1]GOTO9\n";
    EXPECT_EQ(after(asks + "#1=2\nN9M99\n"), Constants(5, 6));
    EXPECT_EQ(after(asks + "#500=2\nN9M99\n"), Constants(std::nullopt, 6));
    EXPECT_EQ(after("#500=#502\n" + asks + "N9M99\n"), Constants(std::nullopt, 6));
    EXPECT_EQ(after("#[#502]=1\n" + asks + "N9M99\n"), Constants(std::nullopt, std::nullopt)); // any of them
    EXPECT_EQ(after("G65P3\n" + asks + "N9M99\nO3\n#501=#502\nM99\n"), Constants(5, std::nullopt));
}

TEST(Solver, AReturnToANumberIsFollowedWhereProgramsCallEachOther) {
    const auto workspace =
        test::analyse_files({{"O1.nc", "O0001\nG65 P2 A1\nM30\n"},
                             {"O2.nc", "O0002\nIF[#1EQ1]GOTO3\nG65 P2 A1\nM99\nN3M99 P9\nN9X1\nM99\n"}},
                            {.complete = true, .jobs = 1});
    const ProgramAnalysis& callee = workspace->programs().back();
    const auto& labels = callee.graph().labels;
    const auto nine = std::ranges::find(labels, Label(std::int64_t{9}), &flow::LabelledBlock::label);
    ASSERT_NE(nine, labels.end());
    EXPECT_TRUE(callee.data().reached(nine->node));
}

TEST(Solver, ACallThatMayComeBackElsewhereDecidesWhetherItsCallerStops) {
    const auto workspace = test::analyse_files({{"O1.nc", "O0001\nG65 P2\nM30\n"},
                                                {"O2.nc", "O0002\nM98 P3\nM99\nN9#3000=1(STOP)\nM99\n"},
                                                {"O3.nc", "O0003\nIF[#500EQ1]GOTO1\nM99\nN1M99 P9\n"}},
                                               {.complete = true, .jobs = 1});
    const dataflow::Summary& summary = workspace->programs()[1].data().summary();
    EXPECT_TRUE(summary.may_stop);
    EXPECT_TRUE(summary.stop_reasons.anything);
}

TEST(Solver, WhatAProgramFurtherUpHandsDownMayBeChangedByACall) {
    const auto after = [](const std::string& store) {
        const auto workspace =
            test::analyse_files({{"main.nc", "VAR\n#_k=#l90(4)\nMACHINING\nL\"S\" V1\nM30\n"},
                                 {"S.ncs", "MACHINING\n#l90=1\n#l5=2\nL\"T\" V1\nG0 X#l90 Z#l5\nRETURN\n"},
                                 {"T.ncs", "MACHINING\n" + store + "\nRETURN\n"}},
                                {.complete = true, .jobs = 1});
        const auto& reads = workspace->programs()[1].facts().all<dataflow::Read>();
        return std::pair(reads[reads.size() - 2].value.constant(), reads.back().value.constant());
    };
    using Constants = std::pair<std::optional<double>, std::optional<double>>;
    EXPECT_EQ(after("#l90=7"), Constants(std::nullopt, 2));
    EXPECT_EQ(after("#l(#g1)=7"), Constants(std::nullopt, 2)); // any of them
    EXPECT_EQ(after("#l5=7"), Constants(1, 2));                // its own
}

TEST(Solver, BoundsOfComparisonsAreKnownInTheBranch) {
    const Value in_branch = last_read("IF[#500LE3]GOTO1\nIF[#500GT7]GOTO1\nX#500\nN1M30\n");
    EXPECT_GT(in_branch.low, 3);
    EXPECT_LE(in_branch.high, 7);
    EXPECT_EQ(in_branch.vacancy, Vacancy::set); // vacant counts as 0
    const Value excluded = last_read("IF[#500EQ#0]GOTO1\nIF[#500EQ0]GOTO1\nX#500\nN1M30\n");
    EXPECT_TRUE(excluded.nonzero);
    EXPECT_EQ(excluded.high, infinity);
}

} // namespace
} // namespace maclint
