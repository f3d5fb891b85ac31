//! Any bytes: no crash, no hang, and no byte of a file lost.
#include "tests/dialect/reading.hpp"
#include "tests/support/lines.hpp"

#include <ctime>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <string_view>

#include <gtest/gtest.h>

namespace maclint {
namespace {

using test::copies_of;
using test::read;

/// Of the processor: other work on the machine does not count.
double seconds_since(std::clock_t start) {
    return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

double seconds_to_read(std::string_view text) {
    const std::clock_t start = std::clock();
    const ProgramFile file = read(text);
    return seconds_since(start);
}

std::string noise(std::size_t size, unsigned lowest, unsigned highest) {
    std::mt19937 random(7);
    std::string out(size, '\0');
    for (char& c : out) c = static_cast<char>(lowest + random() % (highest - lowest + 1));
    return out;
}

/// Whether blocks and runs stand in order, and everything between them is blanks, line ends, comments or
/// marks. Text outside of the tape marks is not asked about: these texts have none.
void expect_everything_accounted_for(std::string_view text) {
    const ProgramFile file = read(text);
    Offset at = 0;
    const auto expect_separator = [&](Offset end) {
        ASSERT_LE(at, end);
        const std::string_view gap = text.substr(at, end - at);
        for (std::size_t i = 0; i < gap.size(); ++i) {
            if (gap[i] == '(') {
                while (i < gap.size() && gap[i] != ')' && gap[i] != '\n' && gap[i] != '\r') ++i;
                continue;
            }
            ASSERT_NE(std::string_view(" \t\r\n;)\0", 7).find(gap[i]), std::string_view::npos)
                << "byte " << at + i << " of [" << text << "] is in no block";
        }
    };
    for (const Program& program : file.programs) {
        ASSERT_EQ(program.sections.size(), 1U);
        EXPECT_EQ(program.sections[0].items.count, program.items.size());
        for (Id item = 0; item < program.items.size(); ++item) {
            const Span span = program.span_of(item);
            expect_separator(span.begin);
            ASSERT_LE(span.end, text.size());
            EXPECT_FALSE(span.empty());
            at = span.end;
        }
    }
    expect_separator(static_cast<Offset>(text.size()));
}

TEST(FanucReader, EveryByteIsInABlockOrBetweenBlocks) {
    static constexpr const char* pieces[] = {"G0X1.", "#1=2", "(A)",  "(B", "\n",  "\r\n", ";",        "\r",
                                             " ",     "\t",   "N10",  "/",  "M30", "O1",   "IF[",      "]",
                                             "GOTO5", "X",    "\xE9", "=",  "<P>", "M99",  "(MACLINT)"};
    std::mt19937 random(11);
    for (int round = 0; round < 3000 && !HasFatalFailure(); ++round) {
        std::string text;
        const std::size_t count = random() % 20;
        for (std::size_t i = 0; i < count; ++i) text += pieces[random() % std::size(pieces)];
        expect_everything_accounted_for(text);
    }
}

TEST(FanucReader, LineOfTenMegabytesIsOneOversizedBlock) {
    const std::string line = "#1=" + copies_of("[1+", 3'500'000);
    const std::clock_t start = std::clock();
    const ProgramFile file = read(line);
    EXPECT_LT(seconds_since(start), 2.0);
    ASSERT_EQ(file.syntax_errors.size(), 1U);
    EXPECT_EQ(file.syntax_errors[0].kind, SyntaxErrorKind::oversized_block);
    EXPECT_LT(seconds_to_read(copies_of("X1.Y2. ", 1'500'000)), 1.0) << "a plain block may be of any length";
}

TEST(FanucReader, MegabyteOfNoiseTakesUnderASecond) {
    EXPECT_LT(seconds_to_read(noise(1 << 20, 0, 255)), 3.0); // three times the aim, for debug builds
    EXPECT_LT(seconds_to_read(noise(1 << 20, 32, 126)), 3.0);
}

TEST(FanucReader, CodeInNoOrderTakesUnderASecondAMegabyte) {
    static constexpr const char* pieces[] = {"G",   "01",   "X",  "#1",   "[",  "]",   "#",    "2",
                                             "EQ",  "GT",   "IF", "GOTO", "=",  "+",   "*",    "SIN",
                                             ",",   "THEN", "/",  "DO1",  "N1", "M98", "Z-1.", "FIX",
                                             "AND", "ATAN", "<",  "O1",   ".5", "#["};
    std::mt19937 random(5);
    for (const std::size_t longest : {8U, 40U, 400U}) {
        std::string text;
        while (text.size() < 1 << 18) {
            for (std::size_t i = 3 + random() % longest; i > 0; --i)
                text += pieces[random() % std::size(pieces)];
            text += '\n';
        }
        EXPECT_LT(seconds_to_read(text), 1.5) << longest; // six times the aim, for sanitizers
    }
}

TEST(FanucReader, GoodBlocksAfterNoiseAreReadAsEver) {
    std::string text;
    for (int i = 0; i < 200; ++i) text += "X=*]" + std::to_string(i) + "\n";
    text += "Z0/M08\nXSIN[30]\nIF[#1EQ#0]GOTO10\nN10 DPRNT[X#1[53]*OUT*OF*RANGE]\n#1=#2/[3]\n";
    EXPECT_EQ(read(text).syntax_errors.size(), 200U);
}

TEST(FanucReader, BracketsWithoutEndAreNoTrouble) {
    EXPECT_LT(seconds_to_read("#1=" + std::string(100'000, '[')), 1.0);
    EXPECT_LT(seconds_to_read("#1=" + std::string(4000, '[') + "1" + std::string(90, ']')), 1.0);
    EXPECT_LT(seconds_to_read("#1=" + copies_of("[1+", 1000)), 1.0);
    EXPECT_LT(seconds_to_read("#1=" + copies_of("-1", 2000)), 1.0);
}

TEST(FanucReader, RowsThatTheParserIsSlowOnAreNotParsed) {
    const auto block_of = [](std::string_view text) { return copies_of(text, 4090 / text.size()) + "\n"; };
    for (const char* row : {"N", "O", ",", ",1", "[#1]", "-", "[", "#", "DPRNT["})
        EXPECT_LT(seconds_to_read(copies_of(block_of(row), 64)), 1.0) << row;
}

TEST(FanucReader, LongBlocksOfNamesAreRead) {
    for (const char* block : {"[#DEPTH]=[#MAXDEPTH]+[#STEPLEN]-[#FINEPASS]*[#STEPLEN]",
                              "IF[[#DEPTH]GT[#MAXDEPTH]]THEN[#DEPTH]=[#MAXDEPTH]",
                              "IF[[[#_ABSMT]EQ[#_ABSOT]]OR[[#A]EQ[#B]]OR[[#C]EQ[#_LONGNAME]]]GOTO#_TARGET"})
        EXPECT_EQ(test::read(std::string(block) + "\n").syntax_errors.size(), 0U) << block;
}

TEST(FanucReader, UnfinishedOutputStatementAtTheEndOfAFileReturns) {
    EXPECT_FALSE(describe(read("DPRNT[")).empty());
    EXPECT_FALSE(describe(read("DPRNT[A")).empty());
    EXPECT_FALSE(describe(read("%\nO1\nDPRNT[A[%")).empty());
}

TEST(FanucReader, NulsAndMarksAndNothingAtAll) {
    EXPECT_TRUE(read("").programs.empty());
    EXPECT_TRUE(read(std::string(100'000, '\0')).programs.empty());
    EXPECT_TRUE(read("%").programs.empty());
    EXPECT_LT(seconds_to_read(std::string(1'000'000, '%')), 2.0);
    EXPECT_LT(seconds_to_read(copies_of("% ", 500'000)), 2.0);
    EXPECT_LT(seconds_to_read(copies_of("%\nO1\n", 100'000)), 2.0);
    EXPECT_LT(seconds_to_read(std::string(1'000'000, '(')), 2.0);
    EXPECT_LT(seconds_to_read(copies_of("(", 500'000) + copies_of("(A)", 200'000)), 2.0);
}

TEST(FanucReader, TimeGrowsWithTheSizeOfTheFile) {
    const std::string block = "N10 IF[#1EQ#0]GOTO10\n#1=#2+[#3*SIN[#4]]\nG1X#1Y#2\n";
    const double once = seconds_to_read(copies_of(block, 2000));
    EXPECT_LT(seconds_to_read(copies_of(block, 8000)), once * 12 + 0.2);
}

TEST(FanucReader, DamagedProgramsOfTheOuterCorpusAreRead) {
    const std::filesystem::path corpus = std::filesystem::path(MACLINT_SHARED) / "corpus" / "fanuc-macro";
    if (!std::filesystem::exists(corpus)) GTEST_SKIP() << "the outer corpus is not at " << corpus;
    std::mt19937 random(3);
    for (const auto& entry : std::filesystem::recursive_directory_iterator(corpus)) {
        if (!entry.is_regular_file() || entry.file_size() > 20'000 || entry.file_size() == 0) continue;
        std::ifstream file(entry.path(), std::ios::binary);
        std::string text((std::istreambuf_iterator<char>(file)), {});
        for (int change = 0; change < 20; ++change)
            text[random() % text.size()] = static_cast<char>(random());
        EXPECT_FALSE(describe(read(text)).empty()) << entry.path();
    }
}

} // namespace
} // namespace maclint
