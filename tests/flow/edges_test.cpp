//! The edges between the blocks, one by one: which block leads to which, why, and where a program is left.
#include "tests/support/analysed.hpp"

#include <map>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::UnorderedElementsAre;

/// Nodes by their lines; where a line has several, with letters: 2a, 2b.
std::vector<std::string> node_names(const ProgramAnalysis& analysis) {
    std::map<std::uint32_t, std::vector<flow::NodeId>> on_line;
    const auto& nodes = analysis.graph().nodes;
    for (flow::NodeId node = 0; node < nodes.size(); ++node)
        on_line[test::line_of(analysis, nodes[node].part.begin)].push_back(node);
    std::vector<std::string> names(nodes.size());
    for (const auto& [line, there] : on_line)
        for (std::size_t i = 0; i < there.size(); ++i) {
            names[there[i]] = std::to_string(line);
            if (there.size() > 1) names[there[i]] += static_cast<char>('a' + i);
        }
    return names;
}

std::string word_for(const flow::Edge& edge) {
    switch (edge.kind) {
    case flow::EdgeKind::next: return "next";
    case flow::EdgeKind::branch: return edge.holds ? "if" : "unless";
    case flow::EdgeKind::jump: return "jump";
    case flow::EdgeKind::computed: return "computed";
    case flow::EdgeKind::back: return "back";
    case flow::EdgeKind::skip: return "skip";
    case flow::EdgeKind::resume: return "resume";
    case flow::EdgeKind::pass: return "pass";
    }
    return "";
}

/// "2 if 3": from, kind and to of every edge.
std::vector<std::string> edges_of(const ProgramAnalysis& analysis) {
    const auto names = node_names(analysis);
    std::vector<std::string> edges;
    for (const flow::Edge& edge : analysis.graph().edges) {
        edges.push_back(names[edge.from] + " " + word_for(edge) + " " + names[edge.to]);
        // An edge that is decided knows by what, and no other does.
        EXPECT_EQ(edge.condition.has_value(), edge.kind == flow::EdgeKind::branch) << edges.back();
        EXPECT_TRUE(edge.holds || edge.condition) << edges.back();
    }
    return edges;
}

std::vector<std::string> edges_in(const std::string& fanuc) {
    return edges_of(test::analyse_fanuc(fanuc)->programs().front());
}

/// Of a MACHINING section that begins on line 2.
std::vector<std::string> din_edges_in(const std::string& machining) {
    return edges_of(test::analyse_text("dinplus", "MACHINING\n" + machining)->programs().front());
}

/// "3 ends": node and kind of every exit.
std::vector<std::string> exits_in(std::string_view dialect, const std::string& text) {
    const auto workspace = test::analyse_text(dialect, text);
    const ProgramAnalysis& analysis = workspace->programs().front();
    const auto names = node_names(analysis);
    std::vector<std::string> exits;
    for (const flow::Exit& exit : analysis.graph().exits) {
        const auto word = [&] {
            switch (exit.kind) {
            case flow::ExitKind::returns: return " returns";
            case flow::ExitKind::ends: return " ends";
            case flow::ExitKind::restarts: return " restarts";
            case flow::ExitKind::alarm: return " alarm";
            case flow::ExitKind::runs_off: return " runs off";
            }
            return "";
        };
        exits.push_back(names[exit.node] + word());
        EXPECT_EQ(exit.effect.has_value(), exit.kind != flow::ExitKind::runs_off) << exits.back();
    }
    return exits;
}

TEST(Edges, OneBlockFollowsTheOther) {
    EXPECT_THAT(edges_in("#1=1\n#2=2\nM30\n"), UnorderedElementsAre("1 next 2", "2 next 3"));
    EXPECT_THAT(edges_in("#3006=1(LOOK)\n#1=2\nM30\n"), UnorderedElementsAre("1 next 2", "2 next 3"));
}

TEST(Edges, AProgramWithoutBlocksHasANodeAllTheSame) {
    const auto workspace = test::analyse_text("dinplus", "PROGRAM HEAD\n#SLIDE $1\n");
    const flow::Graph& graph = workspace->programs().front().graph();
    EXPECT_EQ(graph.nodes.size(), 1U);
    EXPECT_TRUE(graph.edges.empty());
    ASSERT_EQ(graph.exits.size(), 1U);
    EXPECT_EQ(graph.exits.front().node, 0U);
    EXPECT_EQ(graph.exits.front().kind, flow::ExitKind::runs_off);
}

TEST(Edges, AConditionHoldsOrDoesNot) {
    EXPECT_THAT(edges_in("IF[#1EQ1]GOTO4\n#2=2\nM30\nN4M99\n"),
                UnorderedElementsAre("1a if 1b", "1b jump 4", "1a unless 2", "2 next 3"));
    EXPECT_THAT(edges_in("IF[#1EQ1]THEN#2=2\nM30\n"),
                UnorderedElementsAre("1a if 1b", "1b next 2", "1a unless 2"));
}

TEST(Edges, ALoopGoesBackToItsHead) {
    EXPECT_THAT(edges_in("WHILE[#1LT5]DO1\n#1=#1+1\nEND1\nM30\n"),
                UnorderedElementsAre("1 if 2", "2 next 3", "3 back 1", "1 unless 4"));
    EXPECT_THAT(edges_in("DO1\nIF[#1EQ5]GOTO5\nEND1\nM30\nN5M30\n"),
                UnorderedElementsAre("1 next 2a", "2a if 2b", "2b jump 5", "2a unless 3", "3 back 1"));
}

TEST(Edges, LoopsThatAreNoLoopsAreReadAsPlainText) {
    EXPECT_THAT(edges_in("WHILE[#1LT5]DO1\n#1=1\nM30\n"), UnorderedElementsAre("1 next 2", "2 next 3"));
    EXPECT_THAT(edges_in("#1=1\nEND1\nM30\n"), UnorderedElementsAre("1 next 2", "2 next 3"));
    EXPECT_THAT(edges_in("WHILE[#1LT5]DO1\nWHILE[#2LT5]DO2\nEND1\nEND2\nM30\n"),
                UnorderedElementsAre("1 next 2", "2 next 3", "3 next 4", "4 next 5"));
}

TEST(Edges, AWhileThatLacksItsDoIsALoopToTheNextEnd) {
    EXPECT_THAT(edges_in("WHILE[#1LT5]\n#1=#1+1\nEND1\nM30\n"),
                UnorderedElementsAre("1 if 2", "2 next 3", "3 back 1", "1 unless 4"));
}

TEST(Edges, WhatIsDecidedAtTheVeryEndHasAPlaceAfterIt) {
    EXPECT_THAT(edges_in("WHILE[#1LT5]DO1\n#1=#1+1\nEND1\n"),
                UnorderedElementsAre("1 if 2", "2 next 3a", "3a back 1", "1 unless 3b"));
    EXPECT_THAT(exits_in("fanuc", "WHILE[#1LT5]DO1\n#1=#1+1\nEND1\n"), ElementsAre("3b runs off"));
    EXPECT_THAT(exits_in("fanuc", "#1=1\n#2=2\n"), ElementsAre("2 runs off"));
    EXPECT_THAT(exits_in("fanuc", "#1=1\n/#2=2\n"), ElementsAre("1 runs off", "2 runs off"));
}

TEST(Edges, AProgramEndsInOneOfManyKinds) {
    EXPECT_THAT(exits_in("fanuc", "M30\n"), ElementsAre("1 ends"));
    EXPECT_THAT(exits_in("fanuc", "M99\n"), ElementsAre("1 returns"));
    EXPECT_THAT(exits_in("fanuc", "#3000=1(STOP)\n"), ElementsAre("1 alarm"));
    EXPECT_THAT(exits_in("dinplus", "MACHINING\nM99\nEND\n"), ElementsAre("2 restarts"));
    EXPECT_THAT(exits_in("fanuc", "#3006=1\nIF[#1EQ1]GOTO4\nM30\nN4M99\n"),
                ElementsAre("3 ends", "4 returns"));
}

TEST(Edges, ABlockThatMayBeSkippedIsPassedFromWhereverOneComes) {
    EXPECT_THAT(edges_in("#1=1\n/#2=2\nM30\n"), UnorderedElementsAre("1 next 2", "1 skip 3", "2 next 3"));
    EXPECT_THAT(
        edges_in("IF[#1EQ1]THEN#2=2\n/#3=3\nM30\n"),
        UnorderedElementsAre("1a if 1b", "1b next 2", "1a unless 2", "1b skip 3", "1a unless 3", "2 next 3"));
    // A block that is passed is passed again.
    EXPECT_THAT(edges_in("#1=1\n/#2=2\n/#3=3\nM30\n"),
                UnorderedElementsAre("1 next 2", "1 skip 3", "2 next 3", "1 skip 4", "2 skip 4", "3 next 4"));
}

TEST(Edges, WhereAPathBeginsOrAJumpLandsTheBlockMayStillBeSkipped) {
    EXPECT_THAT(edges_in("/#1=1\nM30\n"), UnorderedElementsAre("1a next 1b", "1a skip 2", "1b next 2"));
    EXPECT_THAT(edges_in("#1=1\n/N5#2=2\nGOTO5\n"),
                UnorderedElementsAre("1 next 2a", "2a next 2b", "2a skip 3", "2b next 3", "3 jump 2a"));
}

TEST(Edges, AComputedJumpLeadsToEveryNumber) {
    EXPECT_THAT(edges_in("GOTO#100\nN10#1=1\nN20M30\n"),
                UnorderedElementsAre("1 computed 2", "1 computed 3", "2 next 3"));
}

TEST(Edges, AJumpToANumberThatNoBlockHasLeadsNowhere) {
    EXPECT_THAT(edges_in("GOTO70\nN9M30\n"), IsEmpty());
    EXPECT_THAT(edges_in("GOTO99999999999999999999999\nN9M30\n"), IsEmpty());
    EXPECT_THAT(edges_in("GOTO-99999999999999999999999\nN9M30\n"), IsEmpty());
}

TEST(Edges, ABlockThatCannotBeReadMayJumpWhereItNames) {
    EXPECT_THAT(edges_in("IF[#1EQ1 GOTO4\n#2=2\nM30\nN4M30\n"),
                UnorderedElementsAre("1 next 2", "1 jump 4", "2 next 3"));
}

TEST(Edges, ACalledProgramMayNameMoreLabelsThanItsCallerHas) {
    const auto returning_to = [](const std::vector<std::string>& labels) {
        std::string text = "O2\n";
        for (const std::string& label : labels) text.append("/M99P").append(label).append("\n");
        return text + "M99P" + labels.front() + "\n";
    };
    const std::string few = returning_to({"32", "30", "31", "30"});
    const std::string many =
        returning_to({"39", "38", "37", "36", "35", "34", "33", "32", "31", "30", "30", "31"});
    EXPECT_THAT(edges_in("O1\nM98P2\nN5\nN30\nN31\nN32M30\n" + few),
                UnorderedElementsAre("1 next 2", "2 resume 4", "2 resume 5", "2 resume 6", "3 next 4",
                                     "4 next 5", "5 next 6"));
    // Some are missing: nobody knows that the call does not come back after it. The first N30 is meant.
    for (const std::string& called : {few, many})
        EXPECT_THAT(edges_in("O1\nM98P2\nN30\nN30M30\n" + called),
                    UnorderedElementsAre("1 next 2", "2 next 3", "2 resume 3", "3 next 4"));
    EXPECT_THAT(edges_in("O1\nM98P2\nN5\nM30\n" + many),
                UnorderedElementsAre("1 next 2", "2 next 3", "3 next 4"));
    // Of plain blocks the one with the number begins a stretch.
    EXPECT_THAT(edges_in("O1\nM98P2\nG0X1\nG0X2\nN31G0X3\nM30\n" + many),
                UnorderedElementsAre("1 next 2", "2 next 3", "2 resume 5", "3 next 5", "5 next 6"));
}

TEST(Edges, ACalledProgramResumesWhereItSays) {
    const std::string main = "O1\nM98P2\n#1=5\nN30M30\n", skipped = "O1\n/M98P2\n#1=5\nN30M30\n";
    const std::string perhaps = "O2\nIF[#100EQ1]GOTO9\nM99P30\nN9M99\n", always = "O2\nM99P30\n";
    EXPECT_THAT(edges_in(main + "O2\nM99\n"), UnorderedElementsAre("1 next 2", "2 next 3", "3 next 4"));
    EXPECT_THAT(edges_in(main + perhaps),
                UnorderedElementsAre("1 next 2", "2 next 3", "2 resume 4", "3 next 4"));
    EXPECT_THAT(edges_in(main + always), UnorderedElementsAre("1 next 2", "2 resume 4", "3 next 4"));
    // Where another path leads around a call that always alarms, it is there for that.
    EXPECT_THAT(edges_in(skipped + "O2\n#3000=1\n"),
                UnorderedElementsAre("1 next 2", "1 skip 3", "3 next 4"));
    EXPECT_THAT(edges_in(main + "O2\n#3000=1\n"), UnorderedElementsAre("1 next 2", "2 next 3", "3 next 4"));
    EXPECT_THAT(edges_in(skipped + always),
                UnorderedElementsAre("1 next 2", "1 skip 3", "2 resume 4", "3 next 4"));
    // Nor does a program run off its end after such a call.
    EXPECT_THAT(exits_in("fanuc", "O1\nM98P2\nO2\n#3000=1\n"), IsEmpty());
    EXPECT_THAT(exits_in("fanuc", "O1\nM98P2\nO2\nM99\n"), ElementsAre("2 runs off"));
}

TEST(Edges, OfVeryManyComputedJumpsLeadToOneNodeThatLeadsToAllLabels) {
    constexpr std::size_t many = 150;
    std::string text;
    for (std::size_t i = 1; i <= many; ++i) text += "N" + std::to_string(i) + "GOTO#500\n";
    const auto workspace = test::analyse_fanuc(text + "M30\n");
    const ProgramAnalysis& analysis = workspace->programs().front();
    const std::vector<std::string> edges = edges_of(analysis);
    EXPECT_EQ(edges.size(), 2 * many);
    EXPECT_THAT(edges, testing::Each(testing::HasSubstr(" computed ")));
    const flow::Graph& graph = analysis.graph();
    EXPECT_EQ(graph.nodes.back().effects.count, 0U); // the jumps are made where they stand
    const auto shared = static_cast<flow::NodeId>(graph.nodes.size() - 1);
    EXPECT_EQ(graph.in[shared].size(), many);
    EXPECT_EQ(graph.out[shared].size(), many);
}

TEST(Edges, AChoiceHasTwoBranchesThatMeetAfterIt) {
    EXPECT_THAT(din_edges_in("IF #l1>3\nTHEN\n#l2=1\nENDIF\nM30\n"),
                UnorderedElementsAre("2 if 3", "3 next 4", "4 next 5", "5 next 6", "2 unless 6"));
    EXPECT_THAT(din_edges_in("IF #l1>3\nTHEN\n#l2=1\nELSE\n#l2=2\nENDIF\nM30\n"),
                UnorderedElementsAre("2 if 3", "3 next 4", "4 next 5", "5 next 8", "2 unless 6", "6 next 7",
                                     "7 next 8"));
}

TEST(Edges, ACaseIsReachedByTheTestsBeforeIt) {
    EXPECT_THAT(din_edges_in("SWITCH #l1\nCASE 1\n#l2=1\nBREAK\nENDSWITCH\nM30\n"),
                UnorderedElementsAre("2a next 2b", "2b next 3", "3 if 4", "4 next 5", "5 next 7",
                                     "3 unless 7", "6 next 7"));
    // Without BREAK a branch runs into the next one, not into its test; DEFAULT is what is left.
    EXPECT_THAT(din_edges_in("SWITCH #l1\nCASE 1\n#l2=1\nBREAK\nCASE 2\n#l2=2\nDEFAULT\n#l2=3\nENDSWITCH\n"
                             "M30\n"),
                UnorderedElementsAre("2a next 2b", "2b next 3", "3 if 4", "4 next 5", "5 next 11",
                                     "3 unless 6", "6 if 7", "7 next 9", "6 unless 8", "8 next 9",
                                     "9 next 10", "10 next 11"));
}

TEST(Edges, ASwitchWithoutCasesIsPassed) {
    EXPECT_THAT(din_edges_in("SWITCH #l1\nENDSWITCH\nM30\n"),
                UnorderedElementsAre("2a next 2b", "2b next 4", "3 next 4"));
    EXPECT_THAT(din_edges_in("SWITCH #l1\nDEFAULT\n#l2=1\nENDSWITCH\nM30\n"),
                UnorderedElementsAre("2a next 2b", "2b next 3", "3 next 4", "4 next 5", "5 next 6"));
}

TEST(Edges, WhereOneSlideLeavesTheOthersGoOn) {
    EXPECT_THAT(din_edges_in("$1 N1 M30\n$2 N2 G0 X#l1\nN3 M30\n"),
                UnorderedElementsAre("2 pass 3", "3 next 4"));
    EXPECT_THAT(din_edges_in("$1$2 N1 M30\n$2 N2 G0 X#l1\nN3 M30\n"), UnorderedElementsAre("3 next 4"));
    EXPECT_THAT(din_edges_in("$1 N1 L\"S\"\n$2 N2 G0 X#l1\nN3 M30\nSUBPROGRAM \"S\"\nM30\n"),
                UnorderedElementsAre("2 pass 3", "3 next 4"));
    // A decision has its two ways for all of them.
    EXPECT_THAT(din_edges_in("$1 N1 IF #l1>3\n$1 N2 THEN\n$1 N3 G0 X1\n$1 N4 ENDIF\n$2 N5 G0 X#l1\n"
                             "N6 M30\n"),
                UnorderedElementsAre("2 if 3", "3 next 4", "4 next 5", "5 next 6", "2 unless 6", "6 next 7"));
}

} // namespace
} // namespace maclint
