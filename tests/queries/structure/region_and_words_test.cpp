//! What stands in a block besides its words, which regions do not pair, and how a program is divided.
#include "analyzer/program/block_view.hpp"
#include "analyzer/program/section_kinds.hpp"
#include "analyzer/queries/machine/switches_at.hpp"
#include "analyzer/queries/modal/modes_at.hpp"
#include "analyzer/queries/structure/region_faults.hpp"
#include "analyzer/queries/structure/sections.hpp"
#include "analyzer/queries/structure/sequence_numbers.hpp"
#include "analyzer/queries/words/block_words.hpp"
#include "tests/support/analysed.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint::queries {
namespace {

/// Lines of the faults that a program's numbered loops have.
std::vector<std::uint32_t> loop_faults_in(const std::string& blocks, flow::Imbalance kind) {
    const auto workspace = test::analyse_fanuc("O1\n" + blocks + "M30\n");
    const ProgramAnalysis& analysis = workspace->programs().front();
    std::vector<std::uint32_t> lines;
    for (const flow::RegionFault& fault : numbered_loop_faults(analysis, kind))
        lines.push_back(test::line_of_effect(analysis, fault.effect));
    return lines;
}

TEST(RegionFaults, OfNumberedLoopsAreOfTheKindAskedFor) {
    using testing::ElementsAre;
    using testing::IsEmpty;
    EXPECT_THAT(loop_faults_in("X1.\nEND1\n", flow::Imbalance::never_opened), ElementsAre(3));
    EXPECT_THAT(loop_faults_in("X1.\nEND1\n", flow::Imbalance::never_closed), IsEmpty());
    EXPECT_THAT(loop_faults_in("WHILE[#1LT1]DO1\nX1.\n", flow::Imbalance::never_closed), ElementsAre(2));
}

TEST(RegionFaults, AreHeldBackWhereAnUnreadableBlockMayExplainThem) {
    EXPECT_THAT(loop_faults_in("WHILE[#1LT]DO1\nX1.\nEND1\n", flow::Imbalance::never_opened),
                testing::IsEmpty());
}

TEST(RegionFaults, OfBranchesWithoutAnIfAreOne) {
    const auto faults_in = [](const std::string& blocks) {
        const auto workspace = test::analyse_text("dinplus", "MACHINING\n" + blocks + "N9 M30\nEND\n");
        const ProgramAnalysis& analysis = workspace->programs().front();
        return nesting_faults(analysis, RegionKind::choice).size();
    };
    EXPECT_EQ(faults_in("N1 THEN\nN2 G0 X1\nN3 ELSE\nN4 G0 X2\nN5 ENDIF\n"), 1U);
    EXPECT_EQ(faults_in("N1 ENDIF\nN2 G0 X1\nN3 ENDIF\n"), 2U);
    EXPECT_EQ(faults_in("N1 IF #l1>1\nN2 THEN\nN3 G0 X1\nN4 ENDIF\n"), 0U);
}

struct Standing {
    bool alternatives;
    bool may_call;
    friend bool operator==(const Standing&, const Standing&) = default;
};

/// What stands in the last block before M30.
Standing standing_in(const std::string& blocks) {
    const auto workspace = test::analyse_fanuc("O1\n" + blocks + "\nM30\n");
    const ProgramAnalysis& analysis = workspace->programs().front();
    const Program& program = analysis.program();
    std::vector<Standing> all;
    ModesAt modes_at(analysis);
    SwitchesAt switches_at(analysis);
    for_each_block_with_words(
        program, [](const WordSummary&) { return true; },
        [&](const BlockView& block, std::span<const Word> words, const WordSummary*) {
            const WordsOfBlock one{
                analysis, block,      words, has_modal_calls(program), program.sections.front(),
                modes_at, switches_at};
            all.push_back({has_alternatives(one), may_call(one)});
        });
    return all.at(all.size() - 2);
}

TEST(BlockWords, MayCallByACodeOrAfterAMove) {
    EXPECT_EQ(standing_in("G65P9001A1."), (Standing{false, true}));
    EXPECT_EQ(standing_in("G#1X1."), (Standing{false, true}));
    EXPECT_EQ(standing_in("G66P9001A1.\nX1."), (Standing{false, true}));
    EXPECT_EQ(standing_in("G65P9001A1.\nX1."), (Standing{false, false}));
}

TEST(Sections, AreAskedForByRole) {
    const auto workspace = test::analyse_text("dinplus", "MACHINING\nN1 G0 X1\nN2 M30\nEND\n");
    const Program& program = workspace->programs().front().program();
    using Role = SectionKind::Role;
    EXPECT_TRUE(has_section(program, Role::machining));
    EXPECT_TRUE(has_section(program, Role::end));
    EXPECT_FALSE(has_section(program, Role::contour));
    EXPECT_TRUE(is_whole_main_program(program));
    EXPECT_EQ(program.slice(first_heading(program)), "MACHINING");
    const auto fragment = test::analyse_text("dinplus", "MACHINING\nN1 G0 X1\nN2 M30\n");
    EXPECT_FALSE(is_whole_main_program(fragment->programs().front().program()));
}

TEST(SequenceNumbers, AreADigitAwayWhenOneIsMissingOrTooMany) {
    using testing::AllOf;
    using testing::Contains;
    using testing::Not;
    EXPECT_THAT(numbers_a_digit_away(6), AllOf(testing::SizeIs(18), Contains(60), Contains(16), Contains(66),
                                               Not(Contains(6)), Not(Contains(0)), Not(Contains(600))));
    EXPECT_THAT(numbers_a_digit_away(106), AllOf(Contains(10), Contains(16), Contains(1006),
                                                 Not(Contains(6)))); // nobody writes N06 for N6
    EXPECT_THAT(numbers_a_digit_away(10), AllOf(Contains(0), Contains(1), Contains(100)));
    EXPECT_THAT(numbers_a_digit_away(0), testing::ElementsAre(10, 20, 30, 40, 50, 60, 70, 80, 90));
    // Longer ones cannot be written.
    EXPECT_THAT(numbers_a_digit_away(9'223'372'036'854'775'807), Contains(922'337'203'685'477'580));
}

} // namespace
} // namespace maclint::queries
