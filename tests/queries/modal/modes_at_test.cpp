//! Which codes are in force before a block and with its words, whatever kind of block it is.
#include "analyzer/program/tables.hpp"
#include "analyzer/queries/modal/modes_at.hpp"
#include "tests/support/analysed.hpp"

#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint::queries {
namespace {

using testing::ElementsAre;

/// "G91", or "G90 G91" for one of two, "?" for one that is computed or the caller's, "..." for any other.
std::string spell(const ControlModel& control, GroupId group, const Modes& modes) {
    std::string text;
    for (const Mode& mode : modes.possible) {
        text += text.empty() ? "" : " ";
        text += mode.code ? control.spell(group, *mode.code) : "?";
        if (mode.set_by == Mode::SetBy::call) text += " by call";
    }
    if (modes.unknown) text += text.empty() ? "..." : " ...";
    return text;
}

struct InForce {
    std::string before, with_words;
};

/// In the group of that role at the first block that holds `text`, in the first program.
InForce at_block(const ProgramAnalysis& analysis, std::string_view text, ModalRole role) {
    const GroupId group = analysis.control().group_with(role).value();
    InForce found{"no block", "no block"};
    for_each_block_with_modes(analysis, [&](const BlockView& block, const BlockModes& modes) {
        const bool wanted = analysis.program().slice(block.span).find(text) != std::string_view::npos;
        if (!wanted || found.before != "no block") return;
        found = {spell(analysis.control(), group, modes.before(group)),
                 spell(analysis.control(), group, modes.with_words(group))};
        if (!modes.reached()) found = {"unreached", "unreached"};
    });
    return found;
}

InForce at_block(const std::string& program, std::string_view text, ModalRole role) {
    const auto workspace = test::analyse_fanuc(program);
    return at_block(workspace->programs().front(), text, role);
}

constexpr ModalRole distance = ModalRole::distance;
constexpr ModalRole motion = ModalRole::motion;

TEST(ModesAt, KnowsEveryBlockOfAPlainRun) {
    const std::string program = "O1\nG90 X1.\nG91 X2.\nX3.\nG90 X4.\nM30\n";
    EXPECT_EQ(at_block(program, "X1.", distance).before, "?");
    EXPECT_EQ(at_block(program, "X1.", distance).with_words, "G90");
    EXPECT_EQ(at_block(program, "X2.", distance).before, "G90");
    EXPECT_EQ(at_block(program, "X2.", distance).with_words, "G91");
    EXPECT_EQ(at_block(program, "X3.", distance).before, "G91");
    EXPECT_EQ(at_block(program, "X3.", distance).with_words, "G91");
    EXPECT_EQ(at_block(program, "X4.", distance).before, "G91");
    EXPECT_EQ(at_block(program, "M30", distance).before, "G90");
    EXPECT_EQ(at_block(program, "X3.", ModalRole::cutter_compensation).before, "G40");
}

TEST(ModesAt, KnowsBlocksWithEffectsOfTheirOwn) {
    const std::string program = "O1\n#1=5\nG91 X#1\nG90 G28 Z0\nM30\n";
    EXPECT_EQ(at_block(program, "X#1", distance).before, "?");
    EXPECT_EQ(at_block(program, "X#1", distance).with_words, "G91");
    EXPECT_EQ(at_block(program, "G28", distance).before, "G91");
    EXPECT_EQ(at_block(program, "G28", distance).with_words, "G90");
}

TEST(ModesAt, SaysWhereEachPossibilityComesFrom) {
    const auto workspace =
        test::analyse_fanuc("O1\nG90 X1.\nIF[#100EQ1]GOTO5\nG91 X2.\nX3.\nN5 X4.\nX5.\nM30\n");
    const ProgramAnalysis& analysis = workspace->programs().front();
    const GroupId group = analysis.control().group_with(distance).value();
    std::vector<std::string> where;
    for_each_block_with_modes(analysis, [&](const BlockView& block, const BlockModes& modes) {
        if (test::text_of(analysis, block.span) != "X5.") return;
        for (const Mode& mode : modes.before(group).possible)
            where.push_back(analysis.control().spell(group, mode.code.value()) + " of " +
                            test::text_of(analysis, span_of(analysis, mode)));
        EXPECT_FALSE(modes.before(group).sure_code());
        EXPECT_TRUE(modes.before(group).can_be(90) && modes.before(group).can_be(91));
        EXPECT_FALSE(modes.before(group).can_be(92));
        const std::vector<double> both{90, 91}, one{91};
        EXPECT_TRUE(modes.before(group).is_surely_one_of(both));
        EXPECT_FALSE(modes.before(group).is_surely_one_of(one));
    });
    EXPECT_THAT(where, testing::UnorderedElementsAre("G90 of G90 X1.", "G91 of G91 X2."));
}

TEST(ModesAt, NamesTheBlockOfARunThatSetIt) {
    const auto workspace = test::analyse_fanuc("O1\nG91 X1.\nX2.\nG90 X3.\nM30\n");
    const ProgramAnalysis& analysis = workspace->programs().front();
    const GroupId group = analysis.control().group_with(distance).value();
    std::vector<std::string> where;
    for_each_block_with_modes(analysis, [&](const BlockView& block, const BlockModes& modes) {
        const Modes now = modes.with_words(group);
        if (block.span.begin >= 3)
            where.push_back(test::text_of(analysis, span_of(analysis, now.possible[0])));
    });
    EXPECT_THAT(where, ElementsAre("G91 X1.", "G91 X1.", "G90 X3.", "G90 X3."));
}

TEST(ModesAt, DoesNotKnowWhatAWordWithoutAKnownValueSets) {
    EXPECT_EQ(at_block("O1\nG90\nG#1 X1.\nM30\n", "X1.", distance).with_words, "G90 ...");
    EXPECT_EQ(at_block("O1\nG90\nF#1 X1.\nM30\n", "X1.", distance).with_words, "G90");
    EXPECT_EQ(at_block("O1\nF5.\nF#1 X1.\nM30\n", "X1.", ModalRole::feed).with_words, "F5 ?");
    EXPECT_EQ(at_block("O1\nG90\nIF[#1EQ1]THEN G91\nX1.\nM30\n", "THEN", distance).with_words, "G90 ...");
    EXPECT_EQ(at_block("O1\nG90\nIF[#1EQ1]THEN #2=1\nX1.\nM30\n", "THEN", distance).with_words, "G90");
    EXPECT_EQ(at_block("O1\nG90\nM98 P77\nX1.\nM30\n", "X1.", distance).before, "G90 ...");
}

TEST(ModesAt, GivesTheCodeOfAWordThatPutsBackWhatTheCallerHas) {
    const std::string text = "O1\nIF[#4003EQ90]GOTO5\nG91\nG90 X1.\nN5 G90\nX2.\nM99\n";
    EXPECT_EQ(at_block(text, "X2.", distance).before, "G90");
    const std::string computed = "O1\nIF[#4003NE90]GOTO5\nG91 X#5\nG90 X#6\nX#7\nN5 M99\n";
    EXPECT_EQ(at_block(computed, "X#7", distance).before, "G90");
}

TEST(ModesAt, KnowsWhatCalledProgramsLeave) {
    const auto workspace = test::analyse_files(
        {{"O1.nc", "O1\nG90\nM98 P2\nX1.\nM30\n"}, {"O2.nc", "O2\nG91\nX1.\nM99\n"}}, {false, 1});
    EXPECT_EQ(at_block(test::program(*workspace, "O1"), "X1.", distance).before, "G91 by call");
    EXPECT_EQ(at_block(test::program(*workspace, "O2"), "G91", distance).before, "?");
}

TEST(ModesAt, KnowsNothingOfBlocksThatNoPathReaches) {
    EXPECT_EQ(at_block("O1\nGOTO5\nG90 X1.\nX2.\nN5 M30\n", "X2.", distance).before, "unreached");
    EXPECT_EQ(at_block("O1\nM30\n#1=1\n", "#1", distance).before, "unreached");
}

TEST(ModesAt, EndsACycleByAMotionCode) {
    const std::string run = "O1\nG81 X1. Z-5. R2.\nX2.\nG0 X3.\nX4.\nM30\n";
    constexpr ModalRole cycle = ModalRole::cycle;
    EXPECT_EQ(at_block(run, "X1.", cycle).before, "G80");
    EXPECT_EQ(at_block(run, "X1.", cycle).with_words, "G81");
    EXPECT_EQ(at_block(run, "X2.", cycle).before, "G81");
    EXPECT_EQ(at_block(run, "X3.", cycle).with_words, "G80");
    EXPECT_EQ(at_block(run, "X4.", cycle).before, "G80");
    EXPECT_EQ(at_block(run, "M30", cycle).before, "G80");
    EXPECT_EQ(at_block("O1\nG0 X1.\nG81 X2.\nX3.\nM30\n", "M30", cycle).before, "G81");
    EXPECT_EQ(at_block("O1\nG81 X#1\nG1 X#2\nM30\n", "M30", cycle).before, "G80");
    EXPECT_EQ(at_block("O1\nG81 X#1\nG1 X#2\nM30\n", "G1", cycle).with_words, "G80");
    EXPECT_EQ(at_block("O1\nG81 X#1\nG#100 X5.\nX6.\nM30\n", "X6.", cycle).before, "G81 ...");
}

TEST(ModesAt, CountsWithTheProgramsThatMovesOfARunCall) {
    const auto workspace =
        test::analyse_files({{"O1.nc", "O1\nG90 G17\nG66 P2\nX1.\nX2.\nG18 X3.\nG91 Y1.\nY2.\nG67\nM30\n"},
                             {"O2.nc", "O2\nG91\nM99\n"}},
                            {false, 1});
    const ProgramAnalysis& analysis = test::program(*workspace, "O1");
    EXPECT_EQ(at_block(analysis, "X1.", distance).before, "G90");
    EXPECT_EQ(at_block(analysis, "X2.", distance).before, "G90 ...");
    EXPECT_EQ(at_block(analysis, "Y1.", distance).with_words, "G91");
    EXPECT_EQ(at_block(analysis, "Y2.", distance).before, "G91 ...");
    EXPECT_EQ(at_block(analysis, "X2.", ModalRole::plane).before, "G17");
    EXPECT_EQ(at_block(analysis, "Y1.", ModalRole::plane).before, "G18");
    EXPECT_EQ(at_block(analysis, "X2.", ModalRole::macro_call).before, "G66");
    EXPECT_EQ(at_block(analysis, "G66", ModalRole::macro_call).with_words, "G66");
}

TEST(ModesAt, CountsWithTheMoveOfTheBlockThatWasAskedAboutLast) {
    const auto workspace = test::analyse_files(
        {{"O1.nc", "O1\nG90\nG66 P2\nF5.\nX1.\nS9\nG67\nM30\n"}, {"O2.nc", "O2\nG91\nM99\n"}}, {false, 1});
    const ProgramAnalysis& analysis = test::program(*workspace, "O1");
    const GroupId group = analysis.control().group_with(distance).value();
    std::vector<std::string> before;
    for_each_block_with_modes(analysis, [&](const BlockView& block, const BlockModes& modes) {
        before.push_back(test::text_of(analysis, block.span) + ": " +
                         spell(analysis.control(), group, modes.before(group)));
    });
    EXPECT_THAT(before, testing::IsSupersetOf({"F5.: G90", "X1.: G90", "S9: G90 ..."}));
}

TEST(ModesAt, TakesTheLastWordOfABlock) {
    EXPECT_EQ(at_block("O1\nF#1 F5 X1.\nM30\n", "X1.", ModalRole::feed).with_words, "F5");
    EXPECT_EQ(at_block("O1\nG0 G81 X1. Z-5. R2.\nM30\n", "X1.", ModalRole::cycle).with_words, "G81");
    EXPECT_EQ(at_block("O1\nG81 G0 X1.\nM30\n", "X1.", ModalRole::cycle).with_words, "G80");
}

TEST(ModesAt, CountsTheChannelsThatRunTheBlock) {
    const std::string text = "MACHINING\n$1 N1 G42\n$2 N2 G0 X1\nN3 G0 X2\nN4 Z2\n$1 N5 T2\n$2 N6 T3\nEND\n";
    const auto workspace = test::analyse_text("dinplus", text);
    const ProgramAnalysis& analysis = workspace->programs().front();
    constexpr ModalRole compensation = ModalRole::cutter_compensation;
    EXPECT_EQ(at_block(analysis, "N2", compensation).before, "G40");
    EXPECT_EQ(at_block(analysis, "N4", compensation).before, "G40 G42");
    EXPECT_EQ(at_block(analysis, "T2", compensation).before, "G42");
    EXPECT_EQ(at_block(analysis, "T3", compensation).before, "G40");
    EXPECT_EQ(at_block(analysis, "N4", motion).before, "G0");
}

/// Which groups' modes differ when blocks are asked about alone, backwards, or each second one.
TEST(ModesAt, AnswersInAnyOrderTheSame) {
    std::string text = "O1\n";
    for (const std::string line : {"G90 X1.", "G0 Z5.", "(NOTE)", "G81 X1. Z-5. R2. F100 ; X2.", "G91 X3.",
                                   "#1=5", "G1 G41 X#1", "G2 X4. (A) ", "X5.", "G80 G40 S500", "X6. M3"})
        text += line + "\n";
    const auto workspace = test::analyse_fanuc(text);
    const ProgramAnalysis& analysis = workspace->programs().front();
    const std::size_t groups = analysis.control().groups.size();
    const auto all_of = [&](const BlockModes& modes) {
        std::vector<std::string> all;
        for (std::size_t i = 0; i < groups; ++i) {
            const auto group = static_cast<GroupId>(i);
            all.push_back(spell(analysis.control(), group, modes.before(group)));
            all.push_back(spell(analysis.control(), group, modes.with_words(group)));
        }
        return all;
    };
    std::vector<std::vector<std::string>> in_order;
    for_each_block_with_modes(
        analysis, [&](const BlockView&, const BlockModes& modes) { in_order.push_back(all_of(modes)); });
    ASSERT_GT(in_order.size(), 10U);
    ModesAt again(analysis), back(analysis);
    std::size_t place = 0;
    const auto first = [&](const BlockView& wanted) { // the first block once more, between the others
        for_each_block(analysis.program(), [&](const BlockView& block) {
            EXPECT_EQ(all_of(back(block)), in_order.front()) << wanted.span.begin;
            return false;
        });
    };
    for_each_block(analysis.program(), [&](const BlockView& block) {
        EXPECT_EQ(all_of(ModesAt(analysis)(block)), in_order[place]) << place;
        EXPECT_EQ(all_of(back(block)), in_order[place]) << place;
        first(block);
        if (place % 3 == 1) {
            EXPECT_EQ(all_of(again(block)), in_order[place]) << place;
        }
        ++place;
    });
}

} // namespace
} // namespace maclint::queries
