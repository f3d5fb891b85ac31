//! Jumps go where the control's search stops, and every path through a program is in the graph.
#include "tests/support/analysed.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// 1-based lines of the labels that the jumps of a program reach, in text order; 0 for a jump to nowhere.
std::vector<std::uint32_t> targets_in(const std::string& text) {
    const auto workspace = test::analyse_fanuc(text);
    const ProgramAnalysis& analysis = workspace->programs().front();
    std::vector<std::uint32_t> lines;
    for (const flow::ResolvedJump& jump : analysis.graph().jumps)
        lines.push_back(jump.target ? test::line_of(analysis, jump.target->block.begin) : 0);
    return lines;
}

/// 1-based lines with a node that no way reaches.
std::vector<std::uint32_t> unreached_in(const std::string& text) {
    const auto workspace = test::analyse_fanuc(text);
    const ProgramAnalysis& analysis = workspace->programs().front();
    std::vector<std::uint32_t> lines;
    for (flow::NodeId node = 0; node < analysis.graph().nodes.size(); ++node)
        if (!analysis.data().reached(node))
            lines.push_back(test::line_of(analysis, analysis.graph().nodes[node].part.begin));
    return lines;
}

TEST(Graph, AJumpIsSearchedToTheEndAndThenFromTheTop) {
    // Two N10: from line 3 the one after is found first, from line 5 only the one at the top is left.
    EXPECT_THAT(targets_in("O1\nN10 G0X1.\nGOTO10\nN10 G0X2.\nGOTO10\nM30\n"), ElementsAre(4, 2));
}

TEST(Graph, AJumpToANumberThatIsNotThereHasNoTarget) {
    EXPECT_THAT(targets_in("O1\nGOTO70\nN7 M30\n"), ElementsAre(0));
}

TEST(Graph, AJumpReachesABlockInsideAPlainRun) {
    EXPECT_THAT(targets_in("O1\nIF[#1EQ#0]GOTO30\nN10 G0X1.\nN20 X2.\nN30 X3.\nN40 X4.\nM30\n"),
                ElementsAre(5));
}

TEST(Graph, ABlockThatCannotBeReadMayJumpToWhatItNames) {
    EXPECT_THAT(unreached_in("O1\nG0X1.\nX2.\nIF #1EQ2]GOTO50\nM30\nN50 #2=1\nM30\nN60 #2=2\nM30\n"),
                ElementsAre(8, 9));
}

TEST(Graph, AJumpWithinAnotherProgramOfTheTapeIsNotFound) {
    EXPECT_THAT(targets_in("O1\nGOTO10\nM30\nO2\nN10 M99\n"), ElementsAre(0));
}

TEST(Graph, CallsThatReturnAtManyLabelsShareANode) {
    // 150 calls of a program that comes back at any of 150 labels, never after the call.
    std::string calls, labels = "GOTO999\n", returns;
    for (int i = 0; i < 150; ++i) {
        const std::string label = std::to_string(1000 + i);
        calls += "M98P2\n";
        for (const auto& piece : {"N" + label, " #1=" + label + "\n"}) labels += piece;
        for (const auto& piece : {"IF[#100EQ" + label, "]GOTO" + label + "\n"}) returns += piece;
    }
    std::string ends = "M99P1000\n";
    for (int i = 0; i < 150; ++i)
        ends += "N" + std::to_string(1000 + i) + " M99P" + std::to_string(1000 + i) + "\n";
    const auto workspace = test::analyse_fanuc("O1\n" + calls + labels + "N999 M30\nO2\n" + returns + ends);
    const ProgramAnalysis& analysis = workspace->programs().front();
    EXPECT_LT(analysis.graph().edges.size(), 2000U); // 22,500 if each call had its own
    std::size_t reached = 0;
    for (const flow::LabelledBlock& labelled : analysis.graph().labels)
        reached += analysis.data().reached(labelled.node) ? 1U : 0U;
    EXPECT_EQ(reached, analysis.graph().labels.size()); // N999 from the last of the others
    EXPECT_FALSE(analysis.data().reached(analysis.graph().jumps.front().node))
        << "no call comes back after it";
}

TEST(Graph, WhatFollowsAJumpIsNotReached) {
    EXPECT_THAT(unreached_in("O1\nGOTO10\n#1=5\nN10 M30\n"), ElementsAre(3));
}

TEST(Graph, ABlockThatMayBeSkippedIsPassedBothWays) {
    EXPECT_THAT(unreached_in("O1\n/GOTO10\n#1=5\nN10 M30\n"), IsEmpty());
}

TEST(Graph, TheFirstBlockOfATextMayBeSkippedToo) {
    EXPECT_THAT(unreached_in("/M30\nG0X#5\nM30\n"), IsEmpty());
}

TEST(Graph, BlocksThatMayBeSkippedOneAfterAnotherKeepTheGraphSmall) {
    std::string text = "O1\n";
    constexpr int blocks = 500;
    for (int i = 0; i < blocks; ++i) text += "/X1.\n";
    const auto workspace = test::analyse_fanuc(text + "M30\n");
    const ProgramAnalysis& program = workspace->programs().front();
    EXPECT_LT(program.graph().edges.size(), 5U * blocks);
    // From the first block on every one of them may be skipped.
    const auto past_blocks = [&](flow::EdgeId id) {
        const flow::Node& to = program.graph().nodes[program.graph().edges[id].to];
        return program.program().slice(to.part) != "/X1.";
    };
    const auto last = static_cast<flow::NodeId>(program.graph().nodes.size() - 1);
    EXPECT_TRUE(program.graph().path(0, last, past_blocks, last + 1));
}

TEST(Graph, TheNodeOfAnEffectIsKnown) {
    const auto workspace = test::analyse_fanuc("O1\nIF[#1EQ#0]THEN #2=1\n/#3=1 M98P2\nGOTO10\nN10 M30\n");
    const flow::Graph& graph = workspace->programs().front().graph();
    for_each_effect(workspace->programs().front().program(), [&](EffectId id) {
        const auto node = graph.node_of(id);
        ASSERT_TRUE(node);
        EXPECT_LE(graph.nodes[*node].effects.first, id);
        EXPECT_LT(id, graph.nodes[*node].effects.first + graph.nodes[*node].effects.count);
    });
    EXPECT_FALSE(graph.node_of(1000));
}

TEST(Graph, TestsAfterADefaultComeBeforeIt) {
    const auto unreached = [](const std::string& first, const std::string& second) {
        const auto workspace = test::analyse_text("dinplus", "MACHINING\nINPUT(\"Size\",#l1)\nSWITCH #l1\n" +
                                                                 first + second + "ENDSWITCH\nM30\nEND\n");
        const ProgramAnalysis& program = workspace->programs().front();
        std::vector<std::string> lines;
        for (flow::NodeId node = 0; node < program.graph().nodes.size(); ++node)
            if (!program.data().reached(node))
                lines.emplace_back(program.program().slice(program.graph().nodes[node].part));
        return lines;
    };
    const std::string fallback = "DEFAULT\nG0 X5\nBREAK\n";
    const std::string choice = "CASE 1\nG0 X10\nBREAK\n";
    // Every BREAK goes past ENDSWITCH.
    EXPECT_THAT(unreached(choice, fallback), ElementsAre("ENDSWITCH"));
    EXPECT_THAT(unreached(fallback, choice), ElementsAre("ENDSWITCH"));
}

TEST(Graph, BothWaysOfAConditionAreOpen) {
    EXPECT_THAT(unreached_in("O1\nIF[#100EQ1]GOTO10\n#1=5\nN10 M30\n"), IsEmpty());
}

TEST(Graph, AComputedJumpReachesOnlyWhatItsValueAllows) {
    EXPECT_THAT(unreached_in("O1\n#1=20\nGOTO#1\nN10 #2=1\nGOTO30\nN20 #2=2\nN30 M30\n"), ElementsAre(4, 5));
    EXPECT_THAT(unreached_in("O1\nGOTO#100\nN10 #2=1\nN20 #2=2\nM30\n"), IsEmpty());
}

TEST(Graph, AnAlarmIsNoWayOn) {
    EXPECT_THAT(unreached_in("O1\n#3000=1(STOP)\n#1=5\nM30\n"), ElementsAre(3, 4));
}

TEST(Graph, AStopForTheOperatorIsAWayOn) {
    EXPECT_THAT(unreached_in("O1\n#3006=1(LOOK)\n#1=5\nM30\n"), IsEmpty());
}

TEST(Graph, ACalledProgramMayReturnToAnotherBlock) {
    const auto workspace =
        test::analyse_fanuc("O1\nM98P2\nGOTO40\nN30 #1=5\nN40 M30\nO2\nIF[#100EQ1]GOTO9\nM99P30\nN9 M99\n");
    const ProgramAnalysis& main = workspace->programs().front();
    for (flow::NodeId node = 0; node < main.graph().nodes.size(); ++node)
        EXPECT_TRUE(main.data().reached(node));
}

TEST(Graph, AfterACallThatDoesNotReturnThereNothingIsReached) {
    const std::string alarm = "O2\n#3000=1(STOP)\n";
    EXPECT_THAT(unreached_in("O1\nIF[#500EQ1]GOTO5\nM98P2\nM8\nN5M30\n" + alarm), ElementsAre(4));
    EXPECT_THAT(unreached_in("O1\nM98P2\n#1=5\nM30\n" + alarm), IsEmpty()); // not made for the alarm
    EXPECT_THAT(unreached_in("O1\nIF[#100EQ1]THEN M98P2\n#1=5\nM30\n" + alarm), IsEmpty());
    EXPECT_THAT(unreached_in("O1\nIF[#500EQ1]GOTO5\nM98P3\nM8\nN5M30\n" + alarm + "O3\nM98P2\nM99\n"),
                ElementsAre(4));
    // It returns on some path, or may be left out, or what leads back cannot be read.
    EXPECT_THAT(unreached_in("O1\nM98P2\n#1=5\nM30\nO2\nIF[#100EQ1]GOTO9\n#3000=1\nN9 M99\n"), IsEmpty());
    EXPECT_THAT(unreached_in("O1\nM98P2L#100\n#1=5\nM30\n" + alarm), IsEmpty());
    EXPECT_THAT(unreached_in("O1\n/M98P2\n#1=5\nM30\n" + alarm), IsEmpty());
    EXPECT_THAT(unreached_in("O1\nM98P2\n#1=5\nM30\nO2\nIF[#1EQ1 M99\nM30\n"), IsEmpty());
}

TEST(Graph, AProgramThatReturnsToABlockDoesNotReturnAfterTheCall) {
    const std::string back = "O2\nM99P30\n";
    EXPECT_THAT(unreached_in("O1\nM98P2\n#1=5\nN30 M30\n" + back), ElementsAre(3));
    EXPECT_THAT(unreached_in("O1\nM98P2\n#1=5\nM30\n" + back), IsEmpty()); // an alarm of its own
    EXPECT_THAT(unreached_in("O1\nM98P2\n#1=5\nN30 M30\nO2\nM99P#100\n"), IsEmpty());
    EXPECT_THAT(unreached_in("O1\nM98P2\n#1=5\nN30 M30\nO2\nIF[#100EQ1]GOTO9\nM99P30\nN9 M99\n"), IsEmpty());
}

TEST(Graph, AHugeTargetIsATargetThatIsNotThere) {
    EXPECT_THAT(targets_in("O1\nGOTO99999999999999999999999\nN9 M30\n"), ElementsAre(0));
}

} // namespace
} // namespace maclint
