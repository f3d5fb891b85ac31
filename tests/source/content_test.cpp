//! Content sniffing: NC text with all its oddities is text, files of other kinds are not.
#include "analyzer/source/content.hpp"

#include <random>
#include <string>

#include <gtest/gtest.h>

namespace maclint {
namespace {

using namespace std::string_literals;

TEST(Classify, CallsAFileWithoutCharactersEmpty) {
    EXPECT_EQ(classify(""), Content::empty);
    EXPECT_EQ(classify(" \r\n\t\n"), Content::empty);
    EXPECT_EQ(classify(std::string(5000, '\0')), Content::empty);
    EXPECT_EQ(classify("\xEF\xBB\xBF"), Content::empty);
}

TEST(Classify, CallsAProgramText) { EXPECT_EQ(classify("%\nO0001(TEST)\nG0X0\nM30\n%\n"), Content::text); }

TEST(Classify, AcceptsTapeLeaderAndTrailer) {
    const std::string leader(100'000, '\0');
    EXPECT_EQ(classify(leader + "%\nO1\nM30\n%\n" + leader), Content::text);
}

TEST(Classify, AcceptsTapeReaderControlsAndTheEndOfFileOfDos) {
    EXPECT_EQ(classify("\x12%\nO1\nM30\n%\n\x14\x1A"), Content::text);
}

TEST(Classify, AcceptsTheEscapeSequencesOfATerminal) {
    EXPECT_EQ(classify("O1(\x1B[31mRED\x1B[0m \x1B]0;A\x07 \b\b)\nM30\n"), Content::text);
}

TEST(Classify, AcceptsOneStrayControlByteInAProgram) {
    EXPECT_EQ(classify("%\nO0001\nG0X0Y0Z50.\n\x01G1Z-5.F100\nM30\n%\n"), Content::text);
}

TEST(Classify, AcceptsCommentsInAnyEightBitEncoding) {
    EXPECT_EQ(classify("O1(\x8C\x8A\x96\xBE\x82\xAF)\nM30\n"), Content::text);
}

TEST(Classify, CallsNulsInsideTheTextBinary) { EXPECT_EQ(classify("G0X0\n\0\0\0G1X1\n"s), Content::binary); }

TEST(Classify, CallsARandomFileBinary) {
    std::mt19937 random(7);
    std::string noise;
    while (noise.size() < 4096) noise.push_back(static_cast<char>(random()));
    EXPECT_EQ(classify(noise), Content::binary);
}

TEST(Classify, CallsManyControlBytesBinaryEvenWithoutNuls) {
    EXPECT_EQ(classify("G0\x01\x02\x03\x04X\x05\x06\x07"), Content::binary);
}

TEST(Classify, TellsUtf16FromOtherBinaryFiles) {
    EXPECT_EQ(classify("\xFF\xFE%\0\n\0"s), Content::utf16);
    EXPECT_EQ(classify("\xFE\xFF\0%\0\n"s), Content::utf16);
}

TEST(WithoutEndOfFile, PassesOverTheMarksOfDosAndWhatFillsTheBlockAfterThem) {
    EXPECT_EQ(without_end_of_file("M30\n%\n\x1A"), "M30\n%\n");
    EXPECT_EQ(without_end_of_file("M30\x1A"), "M30");
    EXPECT_EQ(without_end_of_file("M30\r\n\x1A\x1A\x1A"), "M30\r\n");
    EXPECT_EQ(without_end_of_file("M30\n\x1A\0\0\0"s), "M30\n");
    EXPECT_EQ(without_end_of_file("M30\n\x1A\r\n \r\n"), "M30\n");
}

TEST(WithoutEndOfFile, LeavesAMarkThatTextFollowsAndTextWithoutOne) {
    EXPECT_EQ(without_end_of_file("G0X0\n\x1A\nM30\n\x1A"), "G0X0\n\x1A\nM30\n");
    EXPECT_EQ(without_end_of_file("M30\n%\n\0\0"s), "M30\n%\n\0\0"s);
    EXPECT_EQ(without_end_of_file("\x1A"), "");
    EXPECT_EQ(without_end_of_file(""), "");
}

} // namespace
} // namespace maclint
