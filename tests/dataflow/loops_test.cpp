//! The loops of a program as they run, and those that nothing ends.
#include "tests/support/analysed.hpp"

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using Lines = std::pair<std::uint32_t, std::uint32_t>;

std::uint32_t line_of(const ProgramAnalysis& analysis, flow::NodeId node) {
    return test::line_of(analysis, analysis.graph().nodes[node].part.begin);
}

/// 1-based lines of head and latch of each.
std::vector<Lines> lines_of(const ProgramAnalysis& analysis, const std::vector<dataflow::Loop>& loops) {
    std::vector<Lines> lines;
    for (const dataflow::Loop& loop : loops)
        lines.emplace_back(line_of(analysis, loop.head), line_of(analysis, loop.latch));
    return lines;
}

std::vector<Lines> loops_of(const std::string& text) {
    const auto workspace = test::analyse_fanuc(text);
    return lines_of(workspace->programs().front(), workspace->programs().front().loops());
}

std::vector<Lines> inescapable(const std::string& text) {
    const auto workspace = test::analyse_fanuc(text);
    return lines_of(workspace->programs().front(), workspace->programs().front().inescapable_cycles());
}

TEST(Loops, AreInTheOrderOfTheirHeads) {
    EXPECT_THAT(loops_of("O1\nN1#1=#1+1\nWHILE[#2LT9]DO1\n#2=#2+1\nEND1\nIF[#1LT5]GOTO1\nM30\n"),
                ElementsAre(Lines(2, 6), Lines(3, 5)));
    // Two jumps to the same block: two loops, in the order of the jumps.
    EXPECT_THAT(loops_of("O1\nN1#1=#1+1\nIF[#1LT5]GOTO1\nIF[#2LT5]GOTO1\nM30\n"),
                ElementsAre(Lines(2, 3), Lines(2, 4)));
    EXPECT_THAT(loops_of("N1GOTO1\nM30\n"), ElementsAre(Lines(1, 1)));
}

TEST(Loops, AreOnlyThoseThatCanRun) {
    EXPECT_THAT(loops_of("O1\nG0X1\nM30\n"), IsEmpty());
    EXPECT_THAT(loops_of("O1\nGOTO5\nN1#1=#1+1\nIF[#1LT5]GOTO1\nN5M30\n"), IsEmpty());
    EXPECT_THAT(loops_of("O1\n#1=7\nN1#2=#2+1\nIF[#1EQ5]GOTO1\nM30\n"), IsEmpty()); // never again
}

TEST(Loops, KnowTheirRegionUnlessAJumpClosesThem) {
    const auto workspace =
        test::analyse_fanuc("O1\nWHILE[#1LT9]DO1\n#1=#1+1\nEND1\nN5#2=#2+1\nIF[#2LT9]GOTO5\nM30\n");
    const auto& loops = workspace->programs().front().loops();
    ASSERT_EQ(loops.size(), 2U);
    EXPECT_TRUE(loops[0].region);
    EXPECT_FALSE(loops[1].region);
    EXPECT_TRUE(loops[0].holds(loops[0].head));
    EXPECT_TRUE(loops[0].holds(loops[0].latch));
    EXPECT_FALSE(loops[0].holds(loops[1].head));
    for (const dataflow::Loop& loop : loops) {
        EXPECT_TRUE(std::ranges::is_sorted(loop.body));
        EXPECT_EQ(loop.exit_edges.size(), 1U);
        const flow::Edge& back = workspace->programs().front().graph().edges[loop.back];
        EXPECT_EQ(back.from, loop.latch);
        EXPECT_EQ(back.to, loop.head);
    }
}

TEST(Loops, HaveEachItsOwnRegion) {
    const auto workspace = test::analyse_fanuc("O1\nWHILE[#1LT9]DO1\n#1=#1+1\nEND1\nWHILE[#2LT9]DO1\n"
                                               "WHILE[#3LT9]DO2\n#3=#3+1\nEND2\n#2=#2+1\nEND1\nM30\n");
    const ProgramAnalysis& analysis = workspace->programs().front();
    std::vector<std::uint32_t> lines;
    for (const dataflow::Loop& loop : analysis.loops()) {
        ASSERT_TRUE(loop.region);
        lines.push_back(test::line_of_effect(analysis, analysis.regions().all[*loop.region].open));
    }
    EXPECT_THAT(lines, ElementsAre(2, 5, 6));
}

TEST(Loops, HoldBlocksThatStandFarAway) {
    // The second half of the round stands after a long stretch that is no part of it.
    std::string far = "O1\nN1#1=#1+1\nGOTO2\nN3M30\n";
    for (int i = 0; i < 40; ++i) far += "IF[#500EQ" + std::to_string(i) + "]GOTO3\n";
    const auto workspace = test::analyse_fanuc(far + "M30\nN2#2=#2+1\nIF[#2LT9]GOTO1\nGOTO3\n");
    const ProgramAnalysis& analysis = workspace->programs().front();
    ASSERT_EQ(analysis.loops().size(), 1U);
    const auto& body = analysis.loops().front().body;
    EXPECT_TRUE(std::ranges::is_sorted(body));
    EXPECT_EQ(line_of(analysis, body.front()), 2U);
    EXPECT_EQ(line_of(analysis, body.back()), 47U);
    EXPECT_TRUE(std::ranges::none_of(body, [&](flow::NodeId node) {
        return line_of(analysis, node) > 3 && line_of(analysis, node) < 46;
    }));
}

/// Whether the only loop can stop, and whether it has effects that nobody knows.
std::pair<bool, bool> traits(const std::string& before, const std::string& body,
                             const std::string& programs = "") {
    const auto workspace = test::analyse_fanuc("O1\n" + before + "WHILE[#1LT9]DO1\n#1=#1+1\n" + body +
                                               "END1\n#3000=1\nM30\n" + programs);
    const auto& loops = workspace->programs().front().loops();
    EXPECT_EQ(loops.size(), 1U);
    return {loops.front().can_stop, loops.front().has_unknown_effects};
}

TEST(Loops, CanStopWhereTheProgramOrAProgramCalledMayStop) {
    using Traits = std::pair<bool, bool>;
    EXPECT_EQ(traits("", "G0X1\n"), Traits(false, false));
    EXPECT_EQ(traits("M0\n#3006=1(WAIT)\n", ""), Traits(false, false));        // before it, not in it
    EXPECT_EQ(traits("", "IF[#2EQ1]THEN#3000=1(NO)\n"), Traits(false, false)); // a way out of the body
    EXPECT_EQ(traits("", "#2=1\n#3006=1(WAIT)\n"), Traits(true, false));
    EXPECT_EQ(traits("", "/M30\n"), Traits(false, false)); // and so is this
    EXPECT_EQ(traits("", "/M0\n"), Traits(true, false));
    EXPECT_EQ(traits("", "G65P77\n"), Traits(true, true));
    EXPECT_EQ(traits("", "G65P2\n", "O2\n#100=1\nM99\n"), Traits(false, false));
    EXPECT_EQ(traits("", "G65P2\n", "O2\nIF[#500EQ1]THEN#3000=1\nM99\n"), Traits(false, false));
    EXPECT_EQ(traits("", "G65P2\n", "O2\nIF[#5043GT1]THEN#3000=1\nM99\n"), Traits(true, false));
    EXPECT_EQ(traits("", "G65P2\n", "O2\nIF[#500EQ1]THEN#3006=1\nM99\n"), Traits(true, false));
    EXPECT_EQ(traits("", "#2=[[\n").second, true); // a block that nobody can read
}

TEST(Loops, CanStopWhereASwitchOfTheOperatorDecidesOverAnAlarm) {
    // Off in one round, on in the next; #500 is the same in all of them.
    const auto can_stop = [](const std::string& called) {
        return traits("", "G65P2\n", "O2\n" + called + "IF[#500EQ1]THEN#3000=1\nN9M99\n").first;
    };
    EXPECT_TRUE(can_stop("/GOTO9\n"));
    EXPECT_TRUE(can_stop("/M99\n"));
    EXPECT_TRUE(can_stop("#5=0\n/IF[#5EQ1]GOTO9\n/#5=1\nIF[#5EQ0]GOTO9\n"));
    EXPECT_TRUE(can_stop("IF[#501EQ1]GOTO8\n/GOTO9\nN8\n")); // under a condition
    EXPECT_TRUE(can_stop("/#500=1\n"));
    EXPECT_TRUE(can_stop("/G65P3\n"));
    EXPECT_TRUE(can_stop("/#3000=2\n"));
    EXPECT_FALSE(can_stop("/G0X1\n/G0Y1\n")); // the alarm comes in the first round or never
    EXPECT_FALSE(can_stop("IF[#501EQ1]GOTO9\n/G0X1\n"));
    EXPECT_FALSE(traits("", "G65P2\n", "O2\nIF[#500EQ1]THEN#3000=1\n/GOTO9\nG0X1\nN9M99\n").first);
}

TEST(Loops, CanStopWhereTheFirstRoundMayDoWithoutTheCall) {
    const auto can_stop = [](const std::string& body, const std::string& reads) {
        return traits("", body, "O2\nIF[" + reads + "EQ1]THEN#3000=1\nM99\n").first;
    };
    EXPECT_FALSE(can_stop("G65P2A3\n", "#1")); // what the first round has passed the later ones pass, too
    EXPECT_TRUE(can_stop("IF[#3EQ1]GOTO5\nG65P2A3\nN5#3=2\n", "#1"));
    EXPECT_FALSE(can_stop("IF[#3EQ1]GOTO5\nN5#3=2\nG65P2A3\n", "#1"));
    EXPECT_TRUE(can_stop("IF[#500EQ1]GOTO5\nG65P2A3\nGOTO6\nN5#3=2\nN6\n", "#1"));
    EXPECT_TRUE(can_stop("IF[#3EQ1]GOTO5\nG65P2A3\nN5#3=2\n", "#500"));
    EXPECT_TRUE(can_stop("M98P2L#3\n#3=1\n", "#500")); // no times
    EXPECT_FALSE(can_stop("M98P2L2\n#3=1\n", "#500"));
    EXPECT_FALSE(
        can_stop("IF[#3EQ1]GOTO5\n#4=1\nGOTO6\nN5#3=2\nN6\nG65P2A3\nIF[#4EQ1]GOTO7\n#5=1\nN7\n", "#1"));
    // After moves, from its block on: which round makes the first of them is not found out.
    EXPECT_TRUE(can_stop("G0X1\nG66P2A3\n", "#1"));
    EXPECT_TRUE(can_stop("IF[#3EQ1]GOTO5\nG67\nN5G0X1\n#3=2\nG66P2A3\n", "#1"));
    std::string many;
    for (int i = 0; i < 40; ++i) many += "G65P2A" + std::to_string(i + 3) + "\n";
    EXPECT_FALSE(can_stop(many, "#1"));
}

TEST(Loops, ThatAreClosedInTwoPlacesMayDoWithoutTheCallInBetween) {
    const auto workspace = test::analyse_fanuc("O1\n#4=0\nN1#4=#4+1\nG0X#4\nIF[#4LT5]GOTO1\nG65P2\nGOTO1\n"
                                               "O2\nIF[#500GT4]THEN#3000=1\nM99\n");
    EXPECT_TRUE(workspace->programs().front().inescapable_cycles().empty());
}

TEST(Loops, CanStopWhereTheNumberThatDecidesIsMadeByTooManyAssignments) {
    // Each round makes #10 anew and the others of it: what the call passes is always the same.
    const auto made_by = [](int assignments) {
        std::string body = "#10=5\n";
        for (int i = 1; i < assignments; ++i)
            body += "#" + std::to_string(10 + i) + "=#" + std::to_string(9 + i) + "\n";
        return traits("", body + "G65P2A#" + std::to_string(9 + assignments) + "\n",
                      "O2\nIF[#1EQ#500]THEN#3000=1\nM99\n");
    };
    EXPECT_FALSE(made_by(3).first);
    EXPECT_TRUE(made_by(12).first); // nobody follows so many
}

/// `count` jumps back, each to a block before that of the last: loops around loops.
std::string nested(int count, int blocks_inside) {
    std::string text = "O1\n";
    for (int i = 1; i <= count; ++i) text += "N" + std::to_string(i) + "#1=#1+1\n";
    for (int i = 0; i < blocks_inside; ++i) text += "IF[#500EQ1]THEN#2=#500\n";
    for (int i = count; i >= 1; --i)
        text += "IF[#" + std::to_string(500 + i) + "EQ1]GOTO" + std::to_string(i) + "\n";
    return text + "M30\n";
}

TEST(Loops, AreAllListedInAProgramThatIsShortOrNotDeeplyNested) {
    EXPECT_EQ(loops_of(nested(60, 0)).size(), 60U);
    EXPECT_EQ(loops_of(nested(12, 2000)).size(), 12U);
}

TEST(Loops, AreCutOffWhereListingThemWouldTakeTooLong) {
    const auto found = loops_of(nested(150, 2000)); // 150 times more than 2000 blocks
    EXPECT_LT(found.size(), 150U);
    EXPECT_GE(found.size(), 8U);
}

TEST(Loops, AreCutOffWhereEachIsLeftByTooManyJumps) {
    // Computed jumps, so many that they share a node; from it each loop is left for all labels but its own.
    std::string text = "O1\n";
    for (int i = 1; i <= 200; ++i) text += "N" + std::to_string(i) + "#1=#1+1\nGOTO#500\n";
    const auto found = loops_of(text);
    EXPECT_LT(found.size(), 150U);
    EXPECT_GE(found.size(), 50U);
}

// ---- cycles that nothing ends ----

TEST(InescapableCycles, AreThoseThatNoPathLeavesAndNothingStops) {
    EXPECT_THAT(inescapable("O1\nN1#1=#1+1\nGOTO1\nM30\n"), ElementsAre(Lines(2, 3)));
    EXPECT_THAT(inescapable("O1\nN1#1=#1+1\nIF[#1EQ5]GOTO2\nGOTO1\nN2M30\n"), IsEmpty());
    EXPECT_THAT(inescapable("O1\nN1#1=#1+1\nM0\nGOTO1\nM30\n"), IsEmpty());
    EXPECT_THAT(inescapable("O1\nN1#1=#1+1\n#2=#1\n#3006=1(WAIT)\nGOTO1\nM30\n"), IsEmpty());
    EXPECT_THAT(inescapable("O1\nN1#1=#1+1\n#3000=1(NO)\nGOTO1\nM30\n"), IsEmpty());
    EXPECT_THAT(inescapable("O1\nN1#1=#1+1\nG65P77\nGOTO1\nM30\n"), IsEmpty()); // who knows
    EXPECT_THAT(inescapable("O1\nN1#1=#1+1\n#2=[[\nGOTO1\nM30\n"), IsEmpty());
    EXPECT_THAT(inescapable("O1\nN1G65P2\nGOTO1\nM30\nO2\n#100=1\nM99\n"), ElementsAre(Lines(2, 3)));
}

TEST(InescapableCycles, AreLeftByAnAlarmOfACalledProgramThatLooksAtWhatChanges) {
    const std::string called = "M30\nO2\nIF[#1GT5]GOTO9\nM99\nN9#3000=1(NO)\n";
    EXPECT_THAT(inescapable("O1\nN1#1=#1+1\nG65P2A#1\nGOTO1\n" + called), IsEmpty());
    EXPECT_THAT(inescapable("O1\nN1#1=#1+1\nG65P2A3.\nGOTO1\n" + called), ElementsAre(Lines(2, 4)));
    EXPECT_THAT(inescapable("O1\nN1#1=#1+1\n#2=3\nG65P2A#2\nGOTO1\n" + called), ElementsAre(Lines(2, 5)));
    EXPECT_THAT(inescapable("O1\nN1#1=#1+1\nIF[#500EQ1]THEN#2=3\nG65P2A#2\nGOTO1\n" + called), IsEmpty());
}

TEST(InescapableCycles, AreLeftByAnAlarmThatHangsOnWhatIsMadeOfAnArgument) {
    const std::string called = "M30\nO2\n#4=#1*2\nIF[[#3EQ9]OR[#4GT9]]GOTO9\nM99\nN9#3000=1(NO)\n";
    EXPECT_THAT(inescapable("O1\nN1#1=#1+1\nG65P2A#1\nGOTO1\n" + called), IsEmpty());
    EXPECT_THAT(inescapable("O1\nN1#1=#1+1\nG65P2B#1\nGOTO1\n" + called), ElementsAre(Lines(2, 4)));
}

TEST(InescapableCycles, MayBeASingleBlock) {
    EXPECT_THAT(inescapable("N1GOTO1\nM30\n"), ElementsAre(Lines(1, 1)));
}

TEST(InescapableCycles, NameTheExitsThatAreNeverTaken) {
    const auto exit_lines = [](const std::string& text) {
        const auto workspace = test::analyse_fanuc(text);
        const ProgramAnalysis& analysis = workspace->programs().front();
        EXPECT_EQ(analysis.inescapable_cycles().size(), 1U);
        std::vector<std::uint32_t> lines;
        for (const dataflow::Loop& cycle : analysis.inescapable_cycles())
            for (const flow::EdgeId edge : cycle.exit_edges)
                lines.push_back(line_of(analysis, analysis.graph().edges[edge].to));
        return lines;
    };
    // To the GOTO of line 3, which is a node of its own.
    EXPECT_THAT(exit_lines("O1\nN1#1=1\nIF[#1EQ5]GOTO2\nGOTO1\nN2M30\n"), ElementsAre(3));
    EXPECT_THAT(exit_lines("O1\nN1#1=1\nGOTO1\nM30\n"), IsEmpty());
}

TEST(InescapableCycles, AreNotEndedByAStopBeforeThem) {
    EXPECT_THAT(inescapable("O1\n#3006=1(WAIT)\nIF[#10EQ#0]THEN#3000=1(NO)\nN1#10=#10+1\nGOTO1\nM30\n"),
                IsEmpty()); // no call passes #10
    EXPECT_THAT(inescapable("O1\n#3006=1(WAIT)\nN1#1=#1+1\nGOTO1\nM30\n"), ElementsAre(Lines(3, 4)));
    EXPECT_THAT(inescapable("O1\nIF[#500EQ1]THEN#3000=1(NO)\nN1#1=#1+1\nGOTO1\nM30\n"),
                ElementsAre(Lines(3, 4)));
}

TEST(InescapableCycles, EndAtTheirLastJumpBack) {
    EXPECT_THAT(inescapable("O1\nN1#1=#1+1\nIF[#1EQ5]GOTO1\n#2=#1\nIF[#2EQ5]GOTO1\n#3=#1\nGOTO1\nM30\n"),
                ElementsAre(Lines(2, 7)));
    EXPECT_THAT(inescapable("O1\nIF[#500EQ1]GOTO2\nN1#1=1\nGOTO1\nN2#1=2\nGOTO2\nM30\n"),
                ElementsAre(Lines(3, 4), Lines(5, 6)));
}

TEST(InescapableCycles, AreTheOutermostLoopThatRunsForEver) {
    const auto region_line = [](const std::string& text) -> std::uint32_t {
        const auto workspace = test::analyse_fanuc(text);
        const ProgramAnalysis& analysis = workspace->programs().front();
        const auto& cycles = analysis.inescapable_cycles();
        EXPECT_EQ(cycles.size(), 1U);
        if (cycles.size() != 1 || !cycles.front().region) return 0;
        return test::line_of_effect(analysis, analysis.regions().all[*cycles.front().region].open);
    };
    EXPECT_EQ(region_line("O1\nDO1\n#1=#1+1\nEND1\nM30\n"), 2U);
    EXPECT_EQ(region_line("O1\nDO1\nWHILE[#1LT9]DO2\n#1=#1+1\nEND2\nEND1\nM30\n"), 2U);
    // The outer loop is entered once: its round never ends.
    EXPECT_EQ(region_line("O1\nWHILE[#500EQ1]DO1\nDO2\n#1=#1+1\nEND2\nEND1\nM30\n"), 3U);
    EXPECT_EQ(region_line("O1\nN1#1=#1+1\nGOTO1\nM30\n"), 0U);
    // A jump leads round a loop that ends.
    EXPECT_EQ(region_line("O1\nN1WHILE[#1LT9]DO1\n#1=#1+1\nEND1\nGOTO1\nM30\n"), 0U);
}

} // namespace
} // namespace maclint
