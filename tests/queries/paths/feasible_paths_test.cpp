//! A path to a read is one that somebody can go: no more is asked of it, and no less.
#include "analyzer/dataflow/facts/read.hpp"
#include "analyzer/dataflow/facts/store.hpp"
#include "analyzer/queries/loops/loop_counter.hpp"
#include "analyzer/queries/paths/feasible_paths.hpp"
#include "tests/support/analysed.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::UnorderedElementsAre;

/// Whether a path is found to the last read of the variable on which nothing sets it.
bool reaches_uninitialised(const std::string& text, std::int32_t variable) {
    const auto workspace = test::analyse_fanuc("O1\n" + text + "M30\n");
    const ProgramAnalysis& program = workspace->programs().front();
    std::optional<dataflow::Read> last;
    for (const dataflow::Read& read : program.facts().all<dataflow::Read>())
        if (read.variable.number == variable) last = read;
    if (!last) throw std::runtime_error("no such read");
    execution::PathSearch search(program);
    return queries::path_without_assignment(search, program, last->variable, last->node).path.has_value();
}

const std::string sets_5_or_not = "IF[#501EQ1]GOTO10\n#5=1\nN10 G0Z#5\n";

TEST(FeasiblePaths, ACountedLoopInFrontIsPassed) {
    EXPECT_TRUE(reaches_uninitialised("#1=0\nWHILE[#1LT3]DO1\nG0X#1\n#1=#1+1\nEND1\n" + sets_5_or_not, 5));
    EXPECT_TRUE(reaches_uninitialised("#1=0\nN5 G0X#1\n#1=#1+1\nIF[#1LT3]GOTO5\n" + sets_5_or_not, 5));
    // What the test in front of the loop told of #1 holds no longer after it.
    EXPECT_TRUE(reaches_uninitialised(
        "#1=#100\nIF[#1GE3]GOTO99\nWHILE[#1LT3]DO1\n#1=#1+1\nEND1\n" + sets_5_or_not + "N99", 5));
}

TEST(FeasiblePaths, WhatTheRoundsStoreIsNotKnownAfterThem) {
    const std::string loop = "#1=0\n#2=0\n#3=0\nWHILE[#1LT3]DO1\n#1=#1+1\n#2=#502\nEND1\n";
    EXPECT_TRUE(reaches_uninitialised(loop + "IF[#2EQ7]GOTO10\n#5=1\nN10 G0Z#5\n", 5));
    EXPECT_TRUE(reaches_uninitialised(loop + "#4=#2+1\nIF[#4EQ7]GOTO10\n#5=1\nN10 G0Z#5\n", 5));
    // What they do not store is.
    EXPECT_FALSE(reaches_uninitialised(loop +
                                           "#4=#501\n#2=#4\nIF[#501EQ1]GOTO7\n#4=8\nGOTO8\nN7 #4=9\n"
                                           "N8 IF[#4EQ9]GOTO9\n#5=1\nN9 IF[#501NE1]GOTO10\n#5=2\nN10 G0Z#5\n",
                                       5));
}

TEST(FeasiblePaths, WhatIsStoredAfterTheRoundsIsKnownAgain) {
    // #2 is 9 exactly where #501 is 1, so either N9 or the block above it sets #5.
    const std::string loop = "#1=0\nWHILE[#1LT3]DO1\n#1=#1+1\n#2=#502\nEND1\n";
    EXPECT_FALSE(reaches_uninitialised(loop + "IF[#501EQ1]GOTO7\n#2=8\nGOTO8\nN7 #2=9\nN8 IF[#2EQ9]GOTO9\n"
                                              "#5=1\nN9 IF[#501NE1]GOTO10\n#5=2\nN10 G0Z#5\n",
                                       5));
}

TEST(FeasiblePaths, ALoopThatAJumpEntersInItsMiddleIsGoneRound) {
    // The test of the loop stands at its end, where the program comes first.
    EXPECT_TRUE(reaches_uninitialised("#1=0\nGOTO20\nN10 #1=#1+1\nN20 IF[#1LT3]GOTO10\n" + sets_5_or_not, 5));
    // Two ways lead into the loop, to N10 and to N20, of which the first sets #5. The second comes to N20
    // seven times before that lets go.
    const std::string loop = "N10 G0X1.\nN20 IF[#1EQ7]GOTO30\n#1=#1+1\nIF[#1LT9]GOTO10\n#5=1\nN30 ";
    const std::string rest = loop + "G0Z#5\n";
    for (const std::string start :
         {"#1=0\nIF[#501EQ1]GOTO20\n#5=1\n", "#1=0\nIF[#501EQ1]GOTO5\nGOTO20\nN5 #5=1\n"})
        EXPECT_TRUE(reaches_uninitialised(start + rest, 5)) << start;
    // What no round changes is known in the middle, too.
    EXPECT_FALSE(reaches_uninitialised("#1=0\nIF[#503EQ1]THEN #5=1\nIF[#501EQ1]GOTO20\n#5=1\n" + loop +
                                           "IF[#503NE1]GOTO40\nG0Z#5\nN40\n",
                                       5));
}

TEST(FeasiblePaths, ALoopThatSetsTheVariableInItsRoundsIsNotPassedWithoutThem) {
    EXPECT_FALSE(reaches_uninitialised("#1=0\nWHILE[#1LT3]DO1\n#5=#1\n#1=#1+1\nEND1\nG0Z#5\n", 5));
    EXPECT_FALSE(
        reaches_uninitialised("#1=0\nWHILE[#1LT3]DO1\nIF[#1EQ2]THEN #5=#1\n#1=#1+1\nEND1\nG0Z#5\n", 5));
}

TEST(FeasiblePaths, OfTwoDecisionsThatContradictEachOtherEitherMayBeTaken) {
    const std::string second = "IF[#501EQ2]GOTO10\n#6=1\nN10 G0Z#6\n";
    EXPECT_TRUE(reaches_uninitialised("IF[#501EQ1]GOTO5\nG0X5.\nN5 " + second, 6));
    EXPECT_FALSE(reaches_uninitialised("IF[#501EQ1]GOTO5\n#6=5.\nN5 " + second, 6));
}

TEST(FeasiblePaths, ADecisionHoldsUntilItsVariableIsStored) {
    const auto text = [](const std::string& between) {
        return "IF[#501EQ1]GOTO5\n#6=1\nN5 " + between + "\nIF[#501EQ2]GOTO10\n#6=1\nN10 G0Z#6\n";
    };
    EXPECT_TRUE(reaches_uninitialised(text("#501=#5003"), 6));
    EXPECT_FALSE(reaches_uninitialised(text("#502=#5003"), 6));
}

TEST(FeasiblePaths, AMoveAfterACountedLoopFollows) {
    const auto workspace = test::analyse_fanuc("O1\n#1=0\nN2 G4P1\nN5 #1=#1+1\nIF[#1LT3]GOTO5\nG0X1.\nM30\n");
    const ProgramAnalysis& program = workspace->programs().front();
    const auto last = static_cast<flow::NodeId>(program.graph().nodes.size() - 1);
    EXPECT_TRUE(queries::can_follow(program, 1, last));
}

/// Fourteen variables that are set or not, each in a case of its own: 16,384 different ways.
std::string many_cases() {
    std::string text;
    for (int i = 0; i < 14; ++i) {
        const std::string n = std::to_string(i);
        for (const auto& piece : {"IF[#" + std::to_string(600 + i), "EQ1]GOTO3" + n,
                                  "\n#" + std::to_string(10 + i), "=1\nN3" + n + "\n"})
            text += piece;
    }
    return text;
}

TEST(FeasiblePaths, NoneIsLookedForToAnEndThatDoesNotFollow) {
    const auto workspace = test::analyse_fanuc("O1\nG0X1.\n" + many_cases() + "G0Z#10\nM30\n");
    const ProgramAnalysis& program = workspace->programs().front();
    const flow::NodeId read = program.facts().all<dataflow::Read>().back().node;
    const execution::PathFound back = queries::path_on_from(program, read, 1);
    EXPECT_FALSE(back.path.has_value());
    EXPECT_EQ(back.visits, 0U);
    EXPECT_TRUE(queries::path_on_from(program, 1, read).path.has_value());
}

execution::PathFound search_for_last_read(const ProgramAnalysis& program, std::int32_t variable) {
    const dataflow::Read* last = nullptr;
    for (const dataflow::Read& read : program.facts().all<dataflow::Read>())
        if (read.variable.number == variable) last = &read;
    execution::PathSearch search(program);
    return queries::path_without_assignment(search, program, last->variable, last->node);
}

TEST(FeasiblePaths, DecisionsThatHaveNoPartInAFailureMakeNoDifference) {
    std::string later;
    for (int i = 10; i < 24; ++i) later += "IF[#" + std::to_string(i) + "EQ1]GOTO99\n";
    // One of the two tests of #501 sets #5 on every path, which only the search of all of them shows.
    const std::string text =
        "O1\nIF[#501EQ1]GOTO20\n#5=1\nN20\n" + many_cases() + "IF[#501NE1]GOTO21\n#5=2\nN21 G0Z#5\n";
    const auto workspace = test::analyse_fanuc(text + later + "N99 M30\n");
    const execution::PathFound found = search_for_last_read(workspace->programs().front(), 5);
    EXPECT_FALSE(found.path.has_value());
    EXPECT_FALSE(found.gave_up);
    // Nor where they are asked before the read: none of them decides whether a path leads to it.
    const auto asked = test::analyse_fanuc("O1\nIF[#501EQ1]GOTO20\n#5=1\nN20\n" + many_cases() + later +
                                           "IF[#501NE1]GOTO21\n#5=2\nN21 G0Z#5\nN99 M30\n");
    const execution::PathFound none = search_for_last_read(asked->programs().front(), 5);
    EXPECT_FALSE(none.path.has_value());
    EXPECT_FALSE(none.gave_up);
    EXPECT_LT(std::max(found.visits, none.visits), 400U); // of 16,384 paths
}

TEST(FeasiblePaths, DecisionsBeforeALoopAndInItMakeNoDifferenceEither) {
    const std::string end = "IF[#501NE1]GOTO21\n#5=2\nN21 G0Z#5\n";
    std::string before = many_cases();
    before.append("WHILE[#700EQ1]DO1\nX#3\nEND1\n").append(end);
    std::string inside = "WHILE[#700EQ1]DO1\n";
    inside.append(many_cases()).append(end).append("END1\n");
    for (const std::string& text : {before, inside}) {
        const auto workspace = test::analyse_fanuc("O1\nIF[#501EQ1]GOTO20\n#5=1\nN20\n" + text + "M30\n");
        const execution::PathFound found = search_for_last_read(workspace->programs().front(), 5);
        EXPECT_FALSE(found.path.has_value()) << text;
        EXPECT_LT(found.visits, 400U) << text;
    }
}

TEST(FeasiblePaths, AFailureCountsOnlyWhereTheSameVariablesAreEqual) {
    // #1EQ1 contradicts #2NE1 where both are #501, and does not where one of them is #502.
    for (const auto& [first, second] : {std::pair("#501", "#502"), std::pair("#502", "#501")}) {
        const auto workspace = test::analyse_fanuc("O1\nIF[#500EQ1]GOTO10\n#1=" + std::string(first) +
                                                   "\n#2=#501\nGOTO20\nN10 #1=" + second +
                                                   "\n#2=#501\nN20 IF[#1EQ1]GOTO30\nGOTO99\n"
                                                   "N30 IF[#2EQ1]GOTO99\nG0Z#5\nN99 M30\n");
        EXPECT_TRUE(search_for_last_read(workspace->programs().front(), 5).path.has_value()) << first;
    }
}

TEST(FeasiblePaths, AFailureCountsOnlyWhereWhatIsStoredOnTheWayIsTheSame) {
    // #2 is made of #1 behind the place where the paths meet, and decided on after that.
    for (const auto& [first, second] : {std::pair("1", "2"), std::pair("2", "1")}) {
        const auto workspace = test::analyse_fanuc("O1\nIF[#500EQ1]GOTO10\n#1=" + std::string(first) +
                                                   "\nGOTO20\nN10 #1=" + second +
                                                   "\nN20 #2=#1\nIF[#2NE2]GOTO99\nG0Z#5\nN99 M30\n");
        EXPECT_TRUE(search_for_last_read(workspace->programs().front(), 5).path.has_value()) << first;
    }
}

/// Whether a path leads over the node of the block to the program's last node.
bool leads_on_from(const std::string& text, const std::string& block) {
    const auto workspace = test::analyse_fanuc(text);
    const ProgramAnalysis& program = workspace->programs().front();
    const auto& nodes = program.graph().nodes;
    for (flow::NodeId node = 0; node < nodes.size(); ++node)
        if (test::text_of(program, nodes[node].part) == block)
            return queries::can_follow(program, node, static_cast<flow::NodeId>(nodes.size() - 1));
    throw std::runtime_error("no such block");
}

TEST(FeasiblePaths, AFailureCountsOnlyWhereTheSameBlocksAreInTheWay) {
    // Where #102 is set, the path past N11 comes to N7 by way of END1, and would have to pass END1 again.
    // Where it is vacant the path comes there from N11.
    std::string loop = "WHILE[#2LE0]DO1\nN7#2=#2+91\n";
    for (int i = 0; i < 20; ++i) loop += "X#3\n";
    EXPECT_TRUE(leads_on_from("O1\nIF[#501EQ1]GOTO11\nM30\n" + loop +
                                  "/N11IF[#102EQ#0]GOTO7\nEND1\nIF[#102NE#0]GOTO98\nGOTO99\n"
                                  "N98#3000=1(NO)\nN99M30\n",
                              "/N11IF[#102EQ#0]GOTO7"));
}

TEST(FeasiblePaths, AFailureCountsOnlyWhereNoMoreBlocksArePassed) {
    // Straight to N3 the loop at N5 has a way back by N2 and N4, which sets #5. Past N2 it has not.
    std::string text = "#1=0\nIF[#501EQ1]GOTO2\nGOTO3\nN2#9=1\nIF[#502EQ1]GOTO4\nN3X#3\n";
    for (int i = 0; i < 20; ++i) text += "X#3\n";
    text += "N5IF[#1GE3]GOTO9\nIF[#503EQ1]GOTO2\n#1=#1+1\nGOTO5\nN4#5=1\nGOTO5\nN9G0Z#5\n";
    EXPECT_TRUE(reaches_uninitialised(text, 5));
}

TEST(FeasiblePaths, ALoopIsSearchedOnceForAllThatComeToItAlike) {
    std::string text = "O1\n";
    for (int k = 1; k <= 20; ++k)
        text += "IF[#" + std::to_string(600 + k) + "EQ1]GOTO" + std::to_string(k) + "\n";
    text += "M30\n";
    for (int k = 1; k <= 20; ++k) text += "N" + std::to_string(k) + "#10=" + std::to_string(k) + "\nGOTO50\n";
    text += "N50\nWHILE[#700EQ1]DO1\nIF[#701EQ1]GOTO51\nX#3\nN51\n";
    for (int i = 0; i < 100; ++i) text += "X#3\n";
    const auto workspace = test::analyse_fanuc(text + "END1\nIF[#10EQ10.5]GOTO60\nM30\nN60G0Z#5\nM30\n");
    const execution::PathFound found = search_for_last_read(workspace->programs().front(), 5);
    EXPECT_FALSE(found.path.has_value());
    EXPECT_FALSE(found.gave_up);
    EXPECT_LT(found.visits, 600U);
}

TEST(FeasiblePaths, NotEveryOneOfThousandsIsLookedForInALongProgram) {
    std::string text = "O1\nIF[#500EQ1]GOTO5\n#1=1\nN5\n";
    for (int i = 0; i < 30'000; ++i) text += "#2=#501\n";
    const auto workspace = test::analyse_fanuc(text + "M30\n");
    const ProgramAnalysis& program = workspace->programs().front();
    EXPECT_TRUE(queries::path_on_from(program, 0, 1).path.has_value());
    int searches = 1;
    while (queries::path_on_from(program, 0, 1).path.has_value() && searches < 5000) ++searches;
    const execution::PathFound given_up = queries::path_on_from(program, 0, 1);
    EXPECT_TRUE(given_up.gave_up);
    EXPECT_EQ(given_up.visits, 0U);
    EXPECT_GT(searches, 100);
    EXPECT_LT(searches, 5000);
}

TEST(FeasiblePaths, ThousandsOfLoopsInLoopsAreNotLookedAtForEveryOne) {
    // Each N leads back to the first: its loop holds all that stand in front of it.
    std::string text = "O1\nIF[#500EQ1]GOTO5\n#1=1\nN5\n";
    for (int i = 10; i < 6'010; ++i)
        text += "N" + std::to_string(i) + "#2=#501\nIF[#502EQ" + std::to_string(i) + "]GOTO10\n";
    const auto workspace = test::analyse_fanuc(text + "X#1\nM30\n");
    const ProgramAnalysis& program = workspace->programs().front();
    const auto last = static_cast<flow::NodeId>(program.graph().nodes.size() - 1);
    EXPECT_TRUE(queries::path_on_from(program, 0, 1).path.has_value());
    int searches = 1;
    while (!queries::path_on_from(program, 0, last).gave_up && searches < 2000) ++searches;
    EXPECT_LT(searches, 200);
}

/// 1-based lines of the nodes to which a path leads without an assignment to the variable.
std::vector<std::uint32_t> lines_without_assignment(const ProgramAnalysis& program,
                                                    queries::WithoutAssignment& paths, Variable variable) {
    std::vector<std::uint32_t> lines;
    for (flow::NodeId node = 0; node < program.graph().nodes.size(); ++node)
        if (paths.leads_to(variable, node))
            lines.push_back(test::line_of(program, program.graph().nodes[node].part.begin));
    return lines;
}

TEST(WithoutAssignment, PathsEndAtTheAssignment) {
    const auto workspace =
        test::analyse_fanuc("O1\nIF[#500EQ1]GOTO5\n#1=1\nG0X#1\nN5 G0X#1\n#1=2\nG0X#1\nM30\n");
    const ProgramAnalysis& program = workspace->programs().front();
    const Variable variable = program.facts().all<dataflow::Store>().front().variable;
    queries::WithoutAssignment paths(program);
    // Lines 3 and 6 assign; the one behind each is reached only over it.
    const auto before = lines_without_assignment(program, paths, variable);
    EXPECT_THAT(before, testing::AllOf(testing::Contains(3), testing::Contains(5), testing::Contains(6)));
    EXPECT_THAT(before, testing::Not(testing::AnyOf(testing::Contains(4), testing::Contains(7))));
    for (flow::NodeId node = 0; node < program.graph().nodes.size(); ++node)
        if (test::line_of(program, program.graph().nodes[node].part.begin) == 5)
            paths.exclude(variable, node);
    EXPECT_THAT(lines_without_assignment(program, paths, variable),
                testing::Not(testing::AnyOf(testing::Contains(5), testing::Contains(6))));
}

TEST(FeasiblePaths, ASearchFindsTheSameAfterOthers) {
    const auto workspace = test::analyse_fanuc(
        "O1\nIF[#501EQ1]GOTO20\n#5=1\nN20\nIF[#502EQ1]GOTO22\n#6=1\nN22\nIF[#501NE1]GOTO21\n#5=2\n"
        "N21 G0Z#5\nG0X#6\nM30\n");
    const ProgramAnalysis& program = workspace->programs().front();
    const auto first = search_for_last_read(program, 6).path;
    ASSERT_TRUE(first.has_value());
    EXPECT_FALSE(search_for_last_read(program, 5).path.has_value());
    EXPECT_EQ(search_for_last_read(program, 6).path, first);
    program.search_memory().forget();
    EXPECT_EQ(search_for_last_read(program, 6).path, first);
    EXPECT_FALSE(search_for_last_read(program, 5).path.has_value());
}

/// Whether a path leads from the start to the end of one line, where a jump or what follows THEN stands, and
/// from there to that of the other.
bool leads_by_way_of(const std::string& text, std::uint32_t between, std::uint32_t to) {
    const auto workspace = test::analyse_fanuc(text);
    const ProgramAnalysis& program = workspace->programs().front();
    const auto& nodes = program.graph().nodes;
    const auto node_at = [&](std::uint32_t line) {
        for (auto node = static_cast<flow::NodeId>(nodes.size()); node-- > 0;)
            if (test::line_of(program, nodes[node].part.begin) == line) return node;
        throw std::runtime_error("no such line");
    };
    const std::vector<execution::Leg> legs{{node_at(between), {}}, {node_at(to), {}}};
    return execution::PathSearch(program).find(legs).path.has_value();
}

TEST(FeasiblePaths, RoundsAreGoneAlsoFromTheMiddleOfALoop) {
    // From line 4 the loop is gone round until #102 is 2: past line 7, which jumps back to line 4 otherwise.
    const auto text = [](const std::string& step) {
        return "O1\n#100=#500\nGOTO15\nN9#5=#100\n#102=1\nWHILE[#102LT2]DO1\n" + step +
               "N15IF[#501NE0]GOTO9\nEND1\nX1\nM30\n";
    };
    EXPECT_TRUE(leads_by_way_of(text("#102=#102+1\n"), 4, 10));
    EXPECT_FALSE(leads_by_way_of(text("#103=#103+1\n"), 4, 10)); // nothing makes #102 another number
}

TEST(FeasiblePaths, ANumberThatIsNeitherAboveNorBelowZeroIsZero) {
    const std::string set_by_sign = "IF[#7GT0]THEN#5=41\nIF[#7LT0]THEN#5=42\n";
    EXPECT_FALSE(
        reaches_uninitialised("#7=#500\nIF[#7EQ#0]GOTO9\n" + set_by_sign + "IF[#7EQ0]GOTO9\nG#5\nN9", 5));
    EXPECT_TRUE(
        reaches_uninitialised("#7=#500\n" + set_by_sign + "IF[#7EQ0]GOTO9\nG#5\nN9", 5)); // a vacant one
    EXPECT_TRUE(reaches_uninitialised("#7=#500\nIF[#7EQ#0]GOTO9\n" + set_by_sign + "G#5\nN9", 5));
    // Equal to 0, it is not vacant.
    EXPECT_FALSE(
        reaches_uninitialised("IF[#500NE0]GOTO1\n#6=1\nGOTO2\nN1#5=1\nN2IF[#500EQ0]GOTO9\nG#5\nN9", 5));
}

TEST(FeasiblePaths, OneOfTheCasesIsMetWhereAllOthersAreSentAway) {
    const std::string cases = "IF[#500EQ1]THEN#5=11\nIF[#500EQ2]THEN#5=12\nG0Z#5\nN9";
    EXPECT_FALSE(reaches_uninitialised("IF[[#500NE1]AND[#500NE2]]GOTO9\n" + cases, 5));
    EXPECT_FALSE(reaches_uninitialised("WHILE[[#500NE1]AND[#500NE2]]DO1\n#500=#501\nEND1\n" + cases, 5));
    EXPECT_TRUE(reaches_uninitialised("IF[[#500NE1]AND[#500NE3]]GOTO9\n" + cases, 5));
}

TEST(FeasiblePaths, SeveralComparisonsTurnOutTheSameWhenTheyAreAskedAgain) {
    const auto reads = [](const std::string& first, const std::string& again,
                          const std::string& between = "") {
        return reaches_uninitialised("IF[" + first + "]GOTO10\n#5=1\nN10 G0X1.\n" + between + "IF[" + again +
                                         "]GOTO20\nG0Z#5\nN20",
                                     5);
    };
    EXPECT_FALSE(reads("[#501EQ1]AND[#502EQ#503]", "[#501EQ1]AND[#502EQ#503]"));
    EXPECT_FALSE(reads("[#501EQ1]OR[#502EQ2]OR[#503LT3]", "[3GT#503]OR[#501EQ1]OR[#502EQ2]"));
    EXPECT_FALSE(reads("[#501EQ#0]OR[#502GT2]", "[#502GT2]OR[#501EQ#0]"));
    EXPECT_TRUE(reads("[#501EQ1]OR[#502EQ2]", "[#501EQ1]OR[#502EQ3]"));
    EXPECT_TRUE(reads("[#501EQ1]OR[#502LT2]", "[#501EQ1]OR[#502GT2]"));
    EXPECT_TRUE(reads("[#501EQ1]OR[#502EQ2]", "[#501EQ1]OR[#502EQ2]", "#502=#503\n"));
    EXPECT_TRUE(reads("[#501EQ1]OR[#502EQ2]", "[#501EQ1]AND[#502EQ2]"));
}

TEST(FeasiblePaths, WhatTheMachineHoldsMayBeAnotherAfterACallAndAfterG10) {
    const auto reads = [](const std::string& between) {
        const std::string both = "[#5221EQ1]AND[#502EQ#503]";
        return reaches_uninitialised(
            "IF[" + both + "]GOTO10\n#5=1\nN10\n" + between + "IF[" + both + "]GOTO20\nG0Z#5\nN20", 5);
    };
    EXPECT_FALSE(reads("G0X1.\n"));
    EXPECT_TRUE(reads("G10L2P1X1.\n"));
    EXPECT_TRUE(reads("G65P7777\n"));
    EXPECT_TRUE(reads("#5221=2\n"));
}

TEST(FeasiblePaths, WhatAnIndexReadsMayBeAnotherAfterAnyAssignment) {
    const auto reads = [](const std::string& between) {
        const std::string both = "IF[[#[#600]EQ1]AND[#501EQ2]]GOTO";
        return reaches_uninitialised(both + "5\n" + between + both + "10\nN5#5=1\nN10G0Z#5\n", 5);
    };
    EXPECT_FALSE(reads(""));
    EXPECT_TRUE(reads("#100=1\n")); // #600 may be 100
}

TEST(FeasiblePaths, TheOppositeOfSeveralComparisonsTurnsOutOtherwise) {
    const auto reads = [](const std::string& first, const std::string& opposite) {
        return reaches_uninitialised("IF[" + first + "]GOTO10\n#5=1\nN10 G0X1.\nIF[" + opposite +
                                         "]GOTO15\nGOTO20\nN15 G0Z#5\nN20",
                                     5);
    };
    EXPECT_FALSE(reads("[#501EQ1]OR[#502GT2]", "[#501NE1]AND[#502LE2]"));
    EXPECT_FALSE(reads("[#501GE1]OR[#502EQ#0]", "[#501LT1]AND[#502NE#0]"));
    EXPECT_TRUE(reads("[#501EQ1]OR[#502GT2]", "[#501NE1]AND[#502LE3]"));
}

TEST(FeasiblePaths, OfSeveralComparisonsTheOneThatIsLeftDecides) {
    const std::string first_is_greater = "IF[#501GT#503]GOTO4\n#5=1\nN4";
    const std::string both = "IF[[#501GT#503]AND[#502GT#503]]GOTO20\n";
    EXPECT_FALSE(
        reaches_uninitialised(first_is_greater + "IF[#502GT#503]GOTO6\n#5=1\nN6" + both + "G0Z#5\nN20", 5));
    EXPECT_FALSE(
        reaches_uninitialised(first_is_greater + both + "IF[#502GT#503]GOTO15\nGOTO20\nN15G0Z#5\nN20", 5));
    EXPECT_TRUE(
        reaches_uninitialised(first_is_greater + both + "IF[#502GT#504]GOTO15\nGOTO20\nN15G0Z#5\nN20", 5));
    EXPECT_TRUE(reaches_uninitialised(both + "IF[#502GT#503]GOTO15\nGOTO20\nN15G0Z#5\nN20", 5));
}

TEST(FeasiblePaths, SeveralComparisonsAreNotAllDecidedAgainstLaterOneByOne) {
    const auto reads = [](const std::string& first, const std::string& later,
                          const std::string& between = "") {
        return reaches_uninitialised(
            "IF[" + first + "]GOTO10\n#5=1\nN10G0X1.\n" + between + later + "G0Z#5\nN20", 5);
    };
    const std::string both_set = "IF[#501EQ#0]GOTO20\nIF[#502EQ#0]GOTO20\n";
    EXPECT_FALSE(reads("[#501EQ#0]OR[#502EQ#0]", both_set));
    EXPECT_FALSE(reads("[#501EQ1]OR[#502GT#503]", "IF[#502GT#503]GOTO20\nIF[#501EQ1]GOTO20\n"));
    EXPECT_FALSE(reads("[#501LT5]OR[#501GE10]", "IF[#501LT3]GOTO20\nIF[#501GT12]GOTO20\nIF[#501LT5]GOTO20\n"
                                                "IF[#501GE10]GOTO20\n"));
    EXPECT_TRUE(reads("[#501EQ#0]OR[#502EQ#0]", "IF[#501EQ#0]GOTO20\n"));
    EXPECT_TRUE(reads("[#501EQ#0]OR[#502EQ#0]", both_set, "#502=1\n"));
    EXPECT_TRUE(reads("[#501EQ1]OR[#502EQ2]", "IF[#501EQ1]GOTO20\nIF[#502EQ3]GOTO20\n"));
    EXPECT_TRUE(reads("[#501EQ#0]OR[#502EQ#0]OR[#503EQ#0]", both_set));
    // What fails with both set is tried again where one may be vacant.
    EXPECT_TRUE(reaches_uninitialised("IF[#504EQ1]GOTO5\nIF[[#501EQ#0]OR[#502EQ#0]]GOTO8\nGOTO20\nN5G0X1.\n"
                                      "N8G0X2.\n" +
                                          both_set + "G0Z#5\nN20",
                                      5));
}

TEST(FeasiblePaths, TheSwitchOfALevelStaysAsItIs) {
    // Passed by here is passed by there; each of two levels has a switch of its own.
    EXPECT_FALSE(reaches_uninitialised("G0X1.\n/#5=1\nG0X2.\n/G0Z#5\n", 5));
    EXPECT_FALSE(reaches_uninitialised("G0X1.\n/#5=1\n/#6=1\n/3#7=1\nG0X2.\n/3#7=2\n/1G0Z#5\n", 5));
    EXPECT_TRUE(reaches_uninitialised("G0X1.\n/2#5=1\nG0X2.\n/3G0Z#5\n", 5));
    EXPECT_TRUE(reaches_uninitialised("G0X1.\n/#5=1\nG0Z#5\n", 5));
    // So it is where a jump leads to the block, or stands in it.
    EXPECT_FALSE(reaches_uninitialised("IF[#501EQ1]GOTO2\nG0X1.\n/N2#5=1\nG0X2.\n/G0Z#5\n", 5));
    EXPECT_FALSE(reaches_uninitialised("G0X1.\n/GOTO2\n#5=1\nN2\n/GOTO3\nG0Z#5\nN3\n", 5));
    EXPECT_TRUE(reaches_uninitialised("G0X1.\n/IF[#501EQ1]GOTO2\n#5=1\nN2\n/G0X2.\nG0Z#5\n", 5));
    EXPECT_TRUE(reaches_uninitialised("IF[#501EQ1]GOTO3\n/#5=1\nN3G0Z#5\n", 5));
    EXPECT_TRUE(reaches_uninitialised("IF[#501EQ1GOTO3\n/#5=1\nN3G0X1.\n/G0Z#5\n", 5)); // nobody can read it
    EXPECT_FALSE(reaches_uninitialised("/#5=1\n/G0Z#5\n", 5));
    EXPECT_FALSE(reaches_uninitialised("G0X1.\n/#5=1\n/IF[#501EQ1]GOTO3\n/G0Z#5\nN3\n", 5));
}

TEST(FeasiblePaths, WhatRoundsChangeByAFractionIsComparedAsAFraction) {
    // Line 6 lets #1 be above 1 and below 2 after both loops, or never.
    const auto text = [](const std::string& step) {
        return "O1\n#1=0\nWHILE[#1LE1]DO1\n#1=4\nWHILE[#1GE2]DO2\n" + step + "END2\n#102=1\nEND1\nX1\nM30\n";
    };
    EXPECT_TRUE(leads_by_way_of(text("#1=#1-0.5\n"), 7, 10));
    EXPECT_TRUE(leads_by_way_of(text("IF[#1EQ4]THEN#1=1.5\n"), 7, 10));
    EXPECT_TRUE(leads_by_way_of(text("#1=0.5+#1-1\n"), 7, 10));
    EXPECT_TRUE(leads_by_way_of(text("#1=[#1*2-1]/2\n"), 7, 10));
    EXPECT_FALSE(leads_by_way_of(text("#1=#1-1\n"), 7, 10));
}

TEST(FeasiblePaths, AFailureCountsOnlyWhereTheCallersCodesAreTheSame) {
    // Who comes past THEN on line 4 has shown that code 5 is in force, and never comes into it.
    const std::string text = "O1\nN1IF[#100GT#101]GOTO3\nN2#1=#4109\nN3IF[#4001NE5]THEN#500=#4003\n"
                             "N4IF[#3NE#2]GOTO1\nN5#3=COS[ROUND[#501]]\nN6IF[#7EQ#0]GOTO1\n";
    EXPECT_TRUE(leads_by_way_of(text, 5, 4));
}

TEST(FeasiblePaths, AFailureCountsOnlyWhereTheSameIsAssumedOfTheCallersCodes) {
    // Who does not come into the first THEN, as the code is not above #500, does not come out of the loop.
    std::string text = "O1\n#1=#500\nIF[#4001GT#500]THEN#9=1\n";
    for (int i = 0; i < 20; ++i) text += "X#3\n";
    text += "WHILE[#4001LE#1]DO1\n#2=5\nEND1\nX1\nM99\n";
    EXPECT_TRUE(leads_by_way_of(text, 2, 27));
}

/// 1-based lines of the stores in #1 that can be the last one before the only loop.
std::vector<std::uint32_t> lines_of_stores_before_loop(const std::string& text) {
    const auto workspace = test::analyse_fanuc("O1\n" + text + "WHILE[#1LT9]DO1\n#1=#1+1\nEND1\nM30\n");
    const ProgramAnalysis& program = workspace->programs().front();
    const Variable variable = queries::counter_of(program, program.loops().at(0)).value().variable;
    std::vector<std::uint32_t> lines;
    for (const dataflow::Store* store : queries::last_stores_before(program, variable, program.loops().at(0)))
        lines.push_back(test::line_of_effect(program, store->effect));
    return lines;
}

TEST(LastStores, AreThoseOfEveryPathIntoTheLoop) {
    EXPECT_THAT(lines_of_stores_before_loop("#1=1\n#1=2\nG0X1.\n"), ElementsAre(3));
    EXPECT_THAT(lines_of_stores_before_loop("#1=1\nIF[#500EQ1]GOTO5\n#1=2\nN5\n"),
                UnorderedElementsAre(2, 4));
    EXPECT_THAT(lines_of_stores_before_loop("IF[#500EQ1]GOTO5\nN5\n"), IsEmpty());
}

TEST(LastStores, AreFoundInABlockWithSeveral) {
    EXPECT_THAT(lines_of_stores_before_loop("#1=5\n#2=1 #1=0\n"), ElementsAre(3));
    EXPECT_THAT(lines_of_stores_before_loop("#1=5\n#1=0 #2=1\n"), ElementsAre(3));
}

} // namespace
} // namespace maclint
