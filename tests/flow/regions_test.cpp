//! Loops pair as the control pairs them, and one cause gives one fault.
#include "tests/support/analysed.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint {
namespace {

using flow::Imbalance;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::Pair;

/// Each fault with the 1-based line of its block.
std::vector<std::pair<Imbalance, std::uint32_t>> faults_in(const std::string& text) {
    const auto workspace = test::analyse_fanuc(text);
    const ProgramAnalysis& analysis = workspace->programs().front();
    std::vector<std::pair<Imbalance, std::uint32_t>> faults;
    for (const flow::RegionFault& fault : analysis.regions().faults)
        faults.emplace_back(fault.what, test::line_of_effect(analysis, fault.effect));
    return faults;
}

TEST(Regions, ThreeNestedLoopsAreLegal) {
    EXPECT_THAT(faults_in("O1\nWHILE[#1LT5]DO1\nWHILE[#2LT5]DO2\nWHILE[#3LT5]DO3\nEND3\nEND2\nEND1\nM30\n"),
                IsEmpty());
}

TEST(Regions, ANumberMayBeUsedAgainAfterItsEnd) {
    EXPECT_THAT(faults_in("O1\nWHILE[#1LT5]DO1\nEND1\nWHILE[#1LT9]DO1\nEND1\nM30\n"), IsEmpty());
}

TEST(Regions, AFourthLevelIsOneFaultWhateverItsNumber) {
    const std::string three = "O1\nWHILE[#1LT5]DO1\nWHILE[#2LT5]DO2\nWHILE[#3LT5]DO3\n";
    EXPECT_THAT(faults_in(three + "WHILE[#4LT5]DO4\nEND4\nEND3\nEND2\nEND1\nM30\n"),
                ElementsAre(Pair(Imbalance::nested_too_deep, 5)));
    EXPECT_THAT(faults_in(three + "WHILE[#4LT5]DO1\nEND1\nEND3\nEND2\nEND1\nM30\n"),
                ElementsAre(Pair(Imbalance::nested_too_deep, 5)));
}

TEST(Regions, CrossedLoopsAreOneFaultAtTheFirstEnd) {
    EXPECT_THAT(faults_in("O1\nWHILE[#1LT5]DO1\nWHILE[#2LT5]DO2\nEND1\nEND2\nM30\n"),
                ElementsAre(Pair(Imbalance::crossed, 4)));
}

TEST(Regions, AnInnerLoopThatIsNeverClosedIsNotACrossing) {
    EXPECT_THAT(faults_in("O1\nWHILE[#1LT5]DO1\nWHILE[#2LT5]DO2\nEND1\nM30\n"),
                ElementsAre(Pair(Imbalance::never_closed, 3)));
}

TEST(Regions, AnEndWithTheWrongNumberIsOneFaultAtItsDo) {
    EXPECT_THAT(faults_in("O1\nWHILE[#1LT5]DO1\nEND2\nM30\n"), ElementsAre(Pair(Imbalance::never_closed, 2)));
}

TEST(Regions, ADoWithTheNumberOfTheLoopAroundItIsOneFault) {
    EXPECT_THAT(faults_in("O1\nWHILE[#1LT5]DO1\nWHILE[#2LT5]DO1\nEND2\nEND1\nM30\n"),
                ElementsAre(Pair(Imbalance::number_reused, 3)));
}

TEST(Regions, ALoopThatIsNeverClosedDoesNotMakeLaterOnesTooDeep) {
    EXPECT_THAT(faults_in("O1\nDO1\nWHILE[#1LT5]DO1\nWHILE[#2LT5]DO2\nWHILE[#3LT5]DO3\nEND3\nEND2\nEND1\n"
                          "M30\n"),
                ElementsAre(Pair(Imbalance::never_closed, 2)));
}

TEST(Regions, TheNumberOfAnOpenLoopIsInUse) {
    EXPECT_THAT(faults_in("O1\nWHILE[#1LT5]DO1\nWHILE[#2LT5]DO1\nEND1\nEND1\nM30\n"),
                ElementsAre(Pair(Imbalance::number_reused, 3)));
}

TEST(Regions, LoopNumbersGoFromOneToThree) {
    EXPECT_THAT(faults_in("O1\nDO4\nIF[#1GT5]GOTO9\nEND4\nN9 M30\n"),
                ElementsAre(Pair(Imbalance::number_out_of_range, 2)));
    EXPECT_THAT(faults_in("O1\nDO0\nIF[#1GT5]GOTO9\nEND0\nN9 M30\n"),
                ElementsAre(Pair(Imbalance::number_out_of_range, 2)));
}

TEST(Regions, AnEndWithoutDoIsAFault) {
    EXPECT_THAT(faults_in("O1\nG0X1.\nEND1\nM30\n"), ElementsAre(Pair(Imbalance::never_opened, 3)));
}

TEST(Regions, AWhileThatLacksItsDoTakesTheNextEnd) {
    EXPECT_THAT(faults_in("O1\nWHILE[#1LT5]\n#1=#1+1\nEND1\nM30\n"), IsEmpty());
}

TEST(Regions, TheInnermostLoopHoldsItsEndBlockButNotItsWhile) {
    const std::string text =
        "O1\nN1 WHILE[#1LT5]DO1\nN2 WHILE[#2LT5]DO2\nN3 #2=#2+1\nN4 END2\nN5 END1\nN6 M30\n";
    const auto workspace = test::analyse_fanuc(text);
    const ProgramAnalysis& analysis = workspace->programs().front();
    const auto loop_at = [&](const std::string& block) {
        const auto loop =
            analysis.regions().loop_around(analysis.program(), static_cast<Offset>(text.find(block)));
        return loop ? test::line_of_effect(analysis, analysis.regions().all[*loop].open) : 0;
    };
    EXPECT_EQ(loop_at("N1"), 0U);
    EXPECT_EQ(loop_at("N2"), 2U);
    EXPECT_EQ(loop_at("N3"), 3U);
    EXPECT_EQ(loop_at("N4"), 3U);
    EXPECT_EQ(loop_at("N5"), 2U);
    EXPECT_EQ(loop_at("N6"), 0U);
}

} // namespace
} // namespace maclint
