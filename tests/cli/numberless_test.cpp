//! What is left of a block when spacing and numbering no longer count.
#include "cli/report/numberless.hpp"

#include <gtest/gtest.h>

namespace maclint::cli {
namespace {

/// Of the place where `part` stands first.
NumberlessPlace of(const std::string& text, std::string_view part) {
    const Source source = Source::from_bytes("O1.nc", text);
    const auto begin = static_cast<Offset>(text.find(part));
    return Numberless().of(source, {begin, begin + static_cast<Offset>(part.size())});
}

TEST(Numberless, LeavesOutBlanksAndTheSequenceNumber) {
    EXPECT_EQ(of("O1\n /2 N0020 g1 x1.\n", "x1.").line, "/2G1X1.");
    EXPECT_EQ(of("O1\n/2N30G1X1.\r\n", "X1.").line, "/2G1X1.");
    EXPECT_EQ(of("O1\n/2N30G1X1.\r\n", "X1.").part, "X1.");
    EXPECT_EQ(of("O1\nN#3 G1\n", "G1").line, "N#3G1");
    EXPECT_EQ(of("O1\nN20\n", "N20").part, "");
}

TEST(Numberless, LeavesOutTheNumberOfAJumpToABlockThatIsThere) {
    EXPECT_EQ(of("O1\nIF[#1EQ2]GOTO 20\nN0020\n", "GOTO 20").line, "IF[#1EQ2]GOTO@");
    EXPECT_EQ(of("O1\nIF[#1EQ2]GOTO 20\nN0020\n", "20").part, "@");
    EXPECT_EQ(of("O1\nGOTO 20\nN21\n", "GOTO").line, "GOTO20");
    EXPECT_EQ(of("N1 G810 NS2 NE3 Q3\nN2\nN3\n", "G810").line, "G810NS@NE@Q3");
}

TEST(Numberless, LeavesNumbersThatAreCompared) {
    EXPECT_EQ(of("N10 IF[#1NE10]GOTO10\n", "IF").line, "IF[#1NE10]GOTO@");
    EXPECT_EQ(of("N10 IF[#1NE10]GOTO10\n", "#1NE10").part, "#1NE10");
    EXPECT_EQ(of("N10 IF[#1NE10]GOTO10\n", "10]").part, "10]");
    EXPECT_EQ(of("N10 WHILE[#1NE10]DO1\n", "WHILE").line, "WHILE[#1NE10]DO1");
    EXPECT_EQ(of("N10 #1NE10\n", "#1").line, "#1NE10");
    EXPECT_EQ(of("N10 G810 NS10 X[#1NE10] NE10\n", "G810").line, "G810NS@X[#1NE10]NE@");
}

TEST(Numberless, TakesForAPlaceWhatItCoversOfTheLine) {
    EXPECT_EQ(of("N10 #1=10\n", "10\n").part, "10");
    EXPECT_EQ(of("N10 G1 X1. GOTO10\n", "GOTO10").part, "GOTO@");
    EXPECT_EQ(of("N5 N10\nN10\n", "N10").part, "N10");
    EXPECT_EQ(of("/N5 GOTO5\n", "/N5 GOTO").part, "/GOTO");
}

TEST(Numberless, LooksForANumberInTheProgramOfTheJump) {
    const std::string text = "%\nO1\nGOTO20\nO2\nN20\nGOTO 20\n%\nN3 GOTO 20";
    EXPECT_EQ(of(text, "GOTO20").line, "GOTO20");
    EXPECT_EQ(of(text, "GOTO 20").line, "GOTO@");
    EXPECT_EQ(of(text, "N3").line, "GOTO20");
}

TEST(Numberless, ReadsPAndQAsBlocksOnlyWhereTheyAre) {
    EXPECT_EQ(of("N1 G71 P2 Q3 U1.\nN2\nN3\n", "G71").line, "G71P@Q@U1.");
    EXPECT_EQ(of("N1 M99 P2\nN2\n", "P2").part, "P@");
    EXPECT_EQ(of("N1 M98 P2\nN2\n", "P2").line, "M98P2");
    EXPECT_EQ(of("N1 G71 P2.5\nN2\n", "P2").line, "G71P2.5");
    EXPECT_EQ(of("N1 G710 P2\nN2\n", "P2").line, "G710P2");
}

TEST(Numberless, TakesOfALongLineOnlyWhatIsNearThePlace) {
    const std::string far(10000, 'A');
    EXPECT_EQ(of("(" + far + "#1" + far, "#1").line, std::string(2048, 'A') + "#1" + std::string(2046, 'A'));
}

TEST(Numberless, ReadsUmlautsAlikeInBothEncodings) {
    EXPECT_EQ(of("(GR\xC3\x96SSE) G1\n", "G1").line, of("(GR\xD6SSE) G1\n", "G1").line);
}

} // namespace
} // namespace maclint::cli
