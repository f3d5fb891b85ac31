//! What a program has set itself, and how its blocks rely on the motion mode.
#include "analyzer/dataflow/facts/exit_state.hpp"
#include "analyzer/program/block_view.hpp"
#include "analyzer/program/tables.hpp"
#include "analyzer/queries/modal/own_settings.hpp"
#include "analyzer/queries/modal/saved_state.hpp"
#include "tests/support/analysed.hpp"

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint::queries {
namespace {

/// "relies" and "feed" of the block, which stands behind a move in G1.
std::string modal_move_of(const std::string& block) {
    const auto workspace = test::analyse_fanuc("O9001\nG1X0F50.\n" + block + "\n");
    const ProgramAnalysis& analysis = workspace->programs().front();
    const Program& program = analysis.program();
    const Stretch last{static_cast<ItemId>(program.items.size() - 1), last_block(program).value().span};
    const ModalMove move = modal_move_in(analysis, last);
    return std::string(move.relies ? "relies" : "") + (move.gives_feed ? " feed" : "");
}

TEST(ModalMoves, RelyOnTheMotionModeWithoutACodeThatSaysHow) {
    for (const std::string block : {"X5.", "X#24", "M8X5.", "G90X5.", "G80X5.", "Z#26H1D#7"})
        EXPECT_EQ(modal_move_of(block), "relies") << block;
    for (const std::string block : {"G1X5.", "X#24G0", "G28X#24", "G81X5.Z-5.R2.", "G66P9100X5.", "G#1X5.",
                                    "G80G1X5.", "G180X5."}) // a code that no table knows may be a macro
        EXPECT_EQ(modal_move_of(block), "") << block;
}

TEST(ModalMoves, GiveAFeedWithAnFThatHasANumber) {
    EXPECT_EQ(modal_move_of("X5.F100."), "relies feed");
    EXPECT_EQ(modal_move_of("G1X5.F#9"), " feed");
    EXPECT_EQ(modal_move_of("X5.S100"), "relies");
}

TEST(ModalMoves, AreLookedForInTheirOwnBlock) {
    const auto workspace = test::analyse_fanuc("O9001\nG1X1.F50.\nX2.\nG0X3.\n");
    const ProgramAnalysis& analysis = workspace->programs().front();
    const std::string_view text = analysis.program().text;
    const auto run = static_cast<ItemId>(analysis.program().items.size() - 1); // all three blocks
    const auto at = static_cast<Offset>(text.find("X2."));
    const ModalMove move = modal_move_in(analysis, {run, {at, at + 3}});
    EXPECT_TRUE(move.relies);
    EXPECT_FALSE(move.gives_feed);
}

/// What the words for the feed give that came last before the program returns; -1: a computed one.
std::vector<double> last_feeds(const std::string& blocks) {
    const auto workspace = test::analyse_fanuc("O9001\n" + blocks + "M99\n");
    const ProgramAnalysis& analysis = workspace->programs().front();
    const GroupId feed = *analysis.control().group_with(ModalRole::feed);
    std::vector<double> found;
    for (const auto& setting :
         last_settings_before(analysis, analysis.facts().all<dataflow::ExitState>().front().exit.node, feed))
        found.push_back(setting.value_or(-1));
    return found;
}

TEST(LastSettings, AreThoseOfAllPathsAndNoEarlierOnes) {
    using testing::ElementsAre;
    using testing::IsEmpty;
    using testing::UnorderedElementsAre;
    EXPECT_THAT(last_feeds("G1X1.F50.\nX2.F60.\n#1=1\n"), ElementsAre(60.));
    EXPECT_THAT(last_feeds("G1X1.F50.\nX2.F#9\n#1=1\n"), ElementsAre(-1.));
    EXPECT_THAT(last_feeds("G1X1.F50.\nIF[#1EQ1]GOTO5\nX#24F60.\nN5 #1=1\n"), UnorderedElementsAre(50., 60.));
    EXPECT_THAT(last_feeds("G1X1.F50.\nGOTO5\nF60.\nN5 #1=1\n"), ElementsAre(50.)); // F60. is never reached
    EXPECT_THAT(last_feeds("G0X1.S50\n#1=1\n"), IsEmpty());
}

/// Whether the spindle stands from the first block on, which is M5.
bool stays_off(const std::string& blocks) {
    const auto workspace = test::analyse_fanuc("O9001\nM5\n" + blocks + "M99\n");
    const ProgramAnalysis& analysis = workspace->programs().front();
    return stays_at(analysis, 0, {*analysis.control().group_with(ModalRole::spindle), 5});
}

TEST(Codes, StayWhereNoBlockBehindThemSetsAnotherOrMay) {
    EXPECT_TRUE(stays_off("X#1\nX#2\nM5\n"));
    EXPECT_FALSE(stays_off("X#1\nX#2\nM3\n"));
    EXPECT_FALSE(stays_off("X#1\nX#2\nM98P77\n"));
    EXPECT_TRUE(stays_off("X#1\nM99\nM3\n")); // never reached
}

/// The number of a local variable that a macro does not use; 0: it uses them all.
std::int32_t free_local_beside(std::int32_t first_used, std::int32_t last_used) {
    std::string text = "O9001\n";
    for (std::int32_t number = first_used; number <= last_used; ++number)
        text += "#" + std::to_string(number) + "=0\n";
    const auto workspace = test::analyse_fanuc(text + "M99\n");
    const auto found = find_free_local(workspace->programs().front().program());
    return found ? found->number : 0;
}

TEST(FreeLocals, AreTheLastOnesThatNoArgumentReaches) {
    EXPECT_EQ(free_local_beside(1, 10), 33);
    EXPECT_EQ(free_local_beside(27, 33), 16); // no letter means #16
    EXPECT_EQ(free_local_beside(2, 33), 1);   // there is no other
    EXPECT_EQ(free_local_beside(1, 33), 0);
}

} // namespace
} // namespace maclint::queries
