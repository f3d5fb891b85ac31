//! Rules on words: MAC514, MAC559, and the pass that they share.
#include "tests/rules/raised.hpp"

#include <string>

#include <gmock/gmock.h>

namespace maclint {
namespace {

using test::lines_raised;
using test::messages_raised;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

TEST(DuplicateAddress, IsFoundInPlainBlocksAndInOthers) {
    EXPECT_THAT(lines_raised("MAC559", "O1\nG90 G0 X1.\nX1. Y2. X3.\nX4.\nX#1 X5.\nM30\n"),
                ElementsAre(3, 5));
}

TEST(DuplicateAddress, NamesTheWordThatTheControlTakes) {
    const auto messages = messages_raised("MAC559", "O1\nG90 G0 X1. Y2. X3.\nM30\n");
    ASSERT_EQ(messages.size(), 1U);
    EXPECT_THAT(messages[0], HasSubstr("takes 'X3.' and passes 'X1.' over"));
    const auto of_three = messages_raised("MAC559", "O1\nG90 G0 X1. Y2. X3. X4.\nM30\n");
    ASSERT_EQ(of_three.size(), 1U);
    EXPECT_THAT(of_three[0], HasSubstr("takes 'X4.' and passes 'X1.' over"));
}

TEST(DuplicateAddress, SaysWhenBothWordsAreTheSame) {
    const auto messages = messages_raised("MAC559", "O1\nG97 S1000 M3 S1000\nM30\n");
    ASSERT_EQ(messages.size(), 1U);
    EXPECT_THAT(messages[0], HasSubstr("both times as 'S1000'"));
}

TEST(DuplicateAddress, IsFoundOnceInABlockOfAMillionWords) {
    std::string block;
    for (int i = 0; i < 1'000'000; ++i) block += "X1.";
    EXPECT_THAT(lines_raised("MAC559", "O1\n" + block + "\nM30\n"), ElementsAre(2));
}

TEST(DuplicateAddress, IsOneFindingForTwoBlocksInOneLine) {
    const auto messages = messages_raised("MAC559", "O1\nG90 G1 F100.\nX1. Y2. G2 X3. Y4. R5.\nM30\n");
    ASSERT_EQ(messages.size(), 1U);
    EXPECT_THAT(messages[0], HasSubstr("Addresses X, Y"));
}

TEST(DuplicateAddress, IsNoneWhereBlocksMayRepeatIt) {
    EXPECT_THAT(lines_raised("MAC559", "O1\nG90 G54 G0 X1. M3 M8\nG1 X1.,C2. F9.\nM30\n"), IsEmpty());
    EXPECT_THAT(lines_raised("MAC559", "O1\nG65 P9000 I1. J2. I3. J4.\nG100 I1. I2.\nM30\n"), IsEmpty());
    EXPECT_THAT(lines_raised("MAC559", "O1\nG66.1 P9000\nI1. I2.\nG67\nM30\n"), IsEmpty());
    EXPECT_THAT(lines_raised("MAC559", "O1\nG2 X1. I1. I2. F9.\nM30\n"), ElementsAre(2));
}

TEST(DuplicateAddress, IsNoneBetweenAlternatives) {
    EXPECT_THAT(lines_raised("MAC559", "O1\nG0 X1. /X2.\nM30\n"), IsEmpty());
    EXPECT_THAT(lines_raised("MAC559", "O1\n#500=#1\nG65 P1 A1. (A2. A3.)\n(X1. X2.)\nM30\n"), IsEmpty());
}

TEST(ModalGroupConflict, IsFoundInPlainBlocksAndInOthers) {
    EXPECT_THAT(lines_raised("MAC514", "O1\nG90 G54 G17\nG0 G1 X1. F9.\nG91 G28 Z0. G90\nG1 G2 X#1\nM30\n"),
                ElementsAre(3, 4, 5));
}

TEST(ModalGroupConflict, IsNoneBetweenGroupsNorForOneCodeTwice) {
    EXPECT_THAT(
        lines_raised("MAC514", "O1\nG0 G17 G21 G40 G49 G80 G90 G94 G98\nG90 G40 G90\nG#1 G1 X1.\nM30\n"),
        IsEmpty());
    EXPECT_THAT(lines_raised("MAC514", "O1\nM3 M5\nF1. F2.\nM30\n"), IsEmpty());
}

TEST(WordPass, ReachesTheLastBlockOfALongProgram) {
    std::string text = "O1\nG90 G1 F100.\n";
    for (int i = 0; i < 10'000; ++i) text += "X1. Y2.\n";
    EXPECT_THAT(lines_raised("MAC559", text + "X1. X2.\nM30\n"), ElementsAre(10'003));
    EXPECT_THAT(lines_raised("MAC514", text + "G0 G1\nM30\n"), ElementsAre(10'003));
}

} // namespace
} // namespace maclint
