//! Canned cycles that are stored: whether a position carries them out, and in which distance mode.
#include "tests/rules/raised.hpp"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::string drilling(const std::string& blocks) {
    return "O1(PLATE)\nG90 G54 G0 X0 Y0\n" + blocks + "G80\nG0 Z50.\nM30\n";
}

TEST(StoredCycle, MakesNoHoleWhereNoPositionFollows) {
    EXPECT_THAT(
        messages_raised("MAC565", drilling("G81 Z-5. R2. F100. K0\nM8\n")),
        ElementsAre(HasSubstr("'G81' with 'K0' is only stored, and no position follows up to line 5")));
    EXPECT_THAT(lines_raised("MAC565", drilling("G81 X5. Z-5. R2. F100. L0\n")), ElementsAre(3));
    EXPECT_THAT(lines_raised("MAC565", drilling("G81 Z-5. R2. F100. K0\nX5.\n")), IsEmpty());
    EXPECT_THAT(lines_raised("MAC565", drilling("G81 Z-5. R2. F100. K2\n")), IsEmpty());
    EXPECT_THAT(lines_raised("MAC565", drilling("G81 Z-5. R2. F100. K#1\n")), IsEmpty());
    EXPECT_THAT(lines_raised("MAC565", drilling("G76 Z-5. R2. Q1. F100. K0\n")), IsEmpty()) << "K is a shift";
}

TEST(StoredCycle, IsNotFollowedWhereOthersMayMakeTheHoles) {
    EXPECT_THAT(lines_raised("MAC565", drilling("G81 Z-5. R2. F100. K0\nM98 P2\n")), IsEmpty());
    EXPECT_THAT(lines_raised("MAC565", drilling("G81 Z-5. R2. F100. K0\nIF[#1EQ0]GOTO5\nN5\n")), IsEmpty());
    EXPECT_THAT(lines_raised("MAC565", "O1\nG81 Z-5. R2. F100. K0\nM99\n"), IsEmpty());
}

TEST(StoredCycle, EndsWithTheProgram) {
    EXPECT_THAT(lines_raised("MAC565", "O1\nG81 Z-5. R2. F100. K0\nM30\n"), ElementsAre(2));
}

TEST(LevelsOfACycle, AreDistancesThatG90TakesForPositions) {
    EXPECT_THAT(lines_raised("MAC564", drilling("G91 G81 Z-20. R-45. F100. K0\nG90 X5.\nX6.\n")),
                ElementsAre(4));
    EXPECT_THAT(lines_raised("MAC564", drilling("G91\nG81 Z-20. R-45. F100.\nX5.\nG90\nX6.\n")),
                ElementsAre(7));
}

TEST(LevelsOfACycle, AreGivenAgainOrUsedAsTheyWereMeant) {
    EXPECT_THAT(lines_raised("MAC564", drilling("G91 G81 Z-20. R-45. F100. K0\nG90 X5. Z-10. R2.\n")),
                IsEmpty());
    EXPECT_THAT(lines_raised("MAC564", drilling("G91 G81 Z-20. R-45. F100.\nX5.\n")), IsEmpty());
    EXPECT_THAT(lines_raised("MAC564", drilling("G90 G81 Z-20. R2. F100.\nG91 X5. K4\n")), IsEmpty());
    EXPECT_THAT(lines_raised("MAC564", drilling("G91 G81 Z-20. R-45. F100.\nG80\nG90 X5.\n")), IsEmpty());
}

} // namespace
} // namespace maclint::test
