//! Where programs are left, which numbers stand twice, which branches go on into the next.
#include "analyzer/dataflow/facts/comparison.hpp"
#include "analyzer/dataflow/facts/exit_state.hpp"
#include "analyzer/dataflow/facts/store.hpp"
#include "analyzer/queries/paths/exits.hpp"
#include "analyzer/queries/structure/fall_throughs.hpp"
#include "analyzer/queries/structure/repeated_numbers.hpp"
#include "tests/support/analysed.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint::queries {
namespace {

TEST(Exits, StandAtTheWordThatLeavesTheProgram) {
    const auto workspace = test::analyse_fanuc("O9001\nX1.\nM99\n");
    const ProgramAnalysis& analysis = workspace->programs().front();
    const auto exits = analysis.facts().all<dataflow::ExitState>();
    ASSERT_EQ(exits.size(), 1U);
    EXPECT_EQ(test::text_of(analysis, span_of_exit(analysis, exits.front().exit)), "M99");
}

/// The block after which a program runs off its end.
std::string last_block_of(const std::string& text) {
    const auto workspace = test::analyse_fanuc("O9001\n" + text);
    const ProgramAnalysis& analysis = workspace->programs().front();
    const auto last = last_block(analysis.program());
    for (const dataflow::ExitState& exit : analysis.facts().all<dataflow::ExitState>())
        if (exit.exit.kind == flow::ExitKind::runs_off)
            return test::text_of(analysis, last_block_before(analysis, exit.exit, last.value()));
    return {};
}

TEST(Exits, OffTheEndAreAfterTheLastBlockThatRuns) {
    EXPECT_EQ(last_block_of("X1.\nX2.\nX3.\n"), "X3.");
    EXPECT_EQ(last_block_of("X1.\nX#1\n"), "X#1");
    // Where the skip switch is on, the block before M30 is the last one.
    EXPECT_EQ(last_block_of("#1=1\n/M30\n"), "#1=1");
}

TEST(Exits, OfWhichOneSideOfATestEndsInAnAlarm) {
    const auto ends = [](const std::string& text, bool side) {
        const auto workspace = test::analyse_fanuc("O9001\n" + text);
        const ProgramAnalysis& analysis = workspace->programs().front();
        return ends_in_alarm(analysis, analysis.facts().all<dataflow::Comparison>().front().node, side);
    };
    const std::string text = "IF[#1GT5]GOTO9\nX1.\nM99\nN9\n#2=1\n#3000=1\n";
    EXPECT_TRUE(ends(text, true));
    EXPECT_FALSE(ends(text, false));
    EXPECT_FALSE(ends("IF[#1GT5]GOTO9\nM99\nN9 IF[#2GT5]GOTO8\nM99\nN8 #3000=1\n", true));
}

/// Whether the true side of the program's first test ends in an alarm.
bool true_side_ends(const std::string& text) {
    const auto workspace = test::analyse_fanuc("O9001\n" + text);
    const ProgramAnalysis& analysis = workspace->programs().front();
    return ends_in_alarm(analysis, analysis.facts().all<dataflow::Comparison>().front().node, true);
}

TEST(Exits, ThatAreAlarmsMayBeThoseOfACalledProgram) {
    const std::string test = "IF[#1GT5]GOTO9\nM99\n";
    EXPECT_TRUE(true_side_ends(test + "N9 G65P9002\nO9002\n#3000=1\n"));
    EXPECT_TRUE(true_side_ends(test + "N9 #2=1\nG65P9002\nM99\nO9002\n#3000=1\n"));
    EXPECT_FALSE(true_side_ends(test + "N9 G65P9002\nM99\nO9002\nX1.\nM99\n"));
    EXPECT_FALSE(true_side_ends(test + "N9 G65P9002\nM99\n")); // who knows
    EXPECT_FALSE(true_side_ends(test + "N9 #2=1\n"));          // it runs off its end
    EXPECT_FALSE(true_side_ends(test + "N9 #2=1\nM30\n"));
}

TEST(Exits, ThatAreAlarmsAreLookedForSixteenBlocksDeep) {
    const auto ends_after = [](int blocks) {
        std::string text = "IF[#1GT5]GOTO9\nM99\nN9";
        for (int i = 0; i < blocks; ++i) text += "#2=1\n";
        return true_side_ends(text + "#3000=1\n");
    };
    EXPECT_TRUE(ends_after(14)); // the jump and the alarm count as well
    EXPECT_FALSE(ends_after(15));
}

/// The last move before the program's first exit; "none" where there is none.
std::string last_move_of(const std::string& text) {
    const auto workspace = test::analyse_fanuc("O9001\n" + text);
    const ProgramAnalysis& analysis = workspace->programs().front();
    const auto move = last_move_before(analysis, analysis.facts().all<dataflow::ExitState>().front().exit);
    return move ? test::text_of(analysis, *move) : "none";
}

TEST(Exits, StandBehindALastMoveThatIsQuotedWithoutItsNumber) {
    EXPECT_EQ(last_move_of("N1X1.\nN2X2.\nN3M8\nM99\n"), "X2.");
    EXPECT_EQ(last_move_of("G0X1.\nG1X2.\nM99\n"), "G1X2.");
    EXPECT_EQ(last_move_of("N1X1.\nN2X#24\n#1=1\nM99\n"), "X#24");
    EXPECT_EQ(last_move_of("X#24\nN2Z5.\nM9\n#1=1\nM99\n"), "Z5.");
    EXPECT_EQ(last_move_of("M8\n#1=1\nM99\nX1.\n"), "none");
}

TEST(Exits, NothingLeadsAroundTheFirstNodeNorAroundWhatAllPathsShare) {
    const auto holds_for_the_store = [](const std::string& text) {
        const auto workspace = test::analyse_fanuc("O9001\n" + text);
        const ProgramAnalysis& analysis = workspace->programs().front();
        return is_on_every_path(analysis, analysis.facts().all<dataflow::Store>().front().node);
    };
    EXPECT_TRUE(holds_for_the_store("#1=1\nX#1\nM99\n"));
    EXPECT_TRUE(holds_for_the_store("IF[#1EQ1]GOTO5\nX2.\nN5#1=1\nM99\n"));
    EXPECT_FALSE(holds_for_the_store("IF[#1EQ1]GOTO5\n#1=1\nN5M99\n"));
    const auto workspace = test::analyse_fanuc("O9001\nM99X#1\n"); // it is left at its first node
    EXPECT_TRUE(is_on_every_path(workspace->programs().front(), 0));
}

struct Repeated {
    std::int64_t number;
    std::size_t blocks;
    std::uint32_t taken; ///< line; 0: nothing
    friend bool operator==(const Repeated&, const Repeated&) = default;
};

std::vector<Repeated> repeated_in(std::string_view dialect, const std::string& text) {
    const auto workspace = test::analyse_text(dialect, text);
    const ProgramAnalysis& analysis = workspace->programs().front();
    std::vector<Repeated> found;
    for (const RepeatedNumber& one : find_repeated_numbers(analysis))
        found.push_back(
            {one.number, one.blocks.size(), one.taken ? test::line_of(analysis, one.taken->begin) : 0});
    return found;
}

TEST(RepeatedNumbers, AreThoseThatSomethingJumpsTo) {
    using testing::ElementsAre;
    EXPECT_THAT(repeated_in("fanuc", "O1\nN5X1.\nGOTO5\nN5X2.\nN5X3.\nN6X1.\nN6X2.\nM30\n"),
                ElementsAre(Repeated{5, 3, 4}));
    EXPECT_THAT(repeated_in("fanuc", "O1\nN5X1.\nGOTO5\nN6X2.\nM30\n"), testing::IsEmpty());
}

TEST(RepeatedNumbers, OfReferencesAreLookedForInTheirSection) {
    const std::string contour = "FINISHED\nN1 G0 X0 Z0\nN2 G1 X30\nN2 G1 Z-20\nMACHINING\n";
    EXPECT_THAT(repeated_in("dinplus", contour + "N10 G810 NS2 NE2 P2\nN20 M30\nEND\n"),
                testing::ElementsAre(Repeated{2, 2, 0}));
    EXPECT_THAT(repeated_in("dinplus", contour + "N10 G810 NS1 NE1 P2\nN20 M30\nEND\n"), testing::IsEmpty());
    const auto workspace = test::analyse_text("dinplus", contour + "N10 G810 NS2 NE2 P2\nN20 M30\nEND\n");
    const std::vector<RepeatedNumber> found = find_repeated_numbers(workspace->programs().front());
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found.front().doubling, Doubling::referenced); // which of them is meant nobody can tell
}

/// Lines of the branches that go on, and of those into which.
std::vector<std::pair<std::uint32_t, std::uint32_t>> falls_in(const std::string& branches) {
    const auto workspace = test::analyse_text("dinplus", "MACHINING\nN1 INPUT(\"A\",#l1)\nN2 SWITCH #l1\n" +
                                                             branches + "N8 ENDSWITCH\nN9 M30\nEND\n");
    const ProgramAnalysis& analysis = workspace->programs().front();
    std::vector<std::pair<std::uint32_t, std::uint32_t>> lines;
    for (const FallThrough& found : find_fall_throughs(analysis))
        lines.emplace_back(test::line_of_effect(analysis, found.branch),
                           test::line_of_effect(analysis, found.next));
    return lines;
}

TEST(FallThroughs, AreBranchesWithoutABreak) {
    using testing::ElementsAre;
    EXPECT_THAT(falls_in("N3 CASE 1\nN4 G0 X1\nN5 CASE 2\nN6 G0 X2\nN7 BREAK\n"),
                ElementsAre(std::pair(4U, 6U)));
    EXPECT_THAT(falls_in("N3 CASE 1\nN4 G0 X1\nN5 BREAK\nN6 CASE 2\nN7 G0 X2\n"), testing::IsEmpty());
}

} // namespace
} // namespace maclint::queries
