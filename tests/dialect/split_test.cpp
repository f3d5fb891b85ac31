//! Where blocks begin and end, what a tape mark does, and what heads a program.
#include "analyzer/dialect/fanuc/split.hpp"
#include "tests/dialect/reading.hpp"

#include <string>
#include <string_view>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint::fanuc {
namespace {

using ::testing::ElementsAre;

/// The blocks of a text without tape marks, empty ones left out.
std::vector<std::string> blocks_of(std::string_view text) {
    std::vector<std::string> blocks;
    RawBlock block;
    for (Offset at = 0; at < text.size();) {
        cut_block(text, at, Reading::takes, block);
        if (!block.span.empty()) blocks.emplace_back(text.substr(block.span.begin, block.span.length()));
        at = block.next > at ? block.next : at + 1;
    }
    return blocks;
}

/// Every program's blocks, one a line: runs are decoded.
/// Without what is wrong with them.
std::string programs_of(std::string_view text) {
    ProgramFile file = test::read(text);
    file.syntax_errors.clear();
    return describe(file);
}

TEST(FanucSplitter, EveryEndOfBlockEndsABlock) {
    EXPECT_THAT(blocks_of("G0\nG1\r\nG2\rG3;G4\n\r\rG5"), ElementsAre("G0", "G1", "G2", "G3", "G4", "G5"));
    EXPECT_THAT(blocks_of("G0;\nG1;;\n\n"), ElementsAre("G0", "G1"));
}

TEST(FanucSplitter, CommentsHoldSemicolonsAndEndWithTheirLine) {
    EXPECT_THAT(blocks_of("G0(A;B)X1;G1"), ElementsAre("G0(A;B)X1", "G1"));
    EXPECT_THAT(blocks_of("G0(A;B\nG1"), ElementsAre("G0(A;B", "G1"));
}

TEST(FanucSplitter, BlanksAndTapeLeaderAroundABlockAreNotPartOfIt) {
    EXPECT_THAT(blocks_of(std::string_view("\0\0 \tG0 X1 \t\nG1", 14)), ElementsAre("G0 X1", "G1"));
}

TEST(FanucSplitter, CommentsAreToldWithTheirBlock) {
    RawBlock block;
    cut_block("(A)G0(B", 0, Reading::takes, block);
    EXPECT_THAT(block.comments, ElementsAre(Span{0, 3}, Span{5, 7}));
}

TEST(FanucTape, LeaderBeforeTheFirstMarkAndTextAfterTheLastAreNotRead) {
    EXPECT_EQ(programs_of("JOB 17 OF MONDAY\n%\nO1\n#1=1\n%\n#2=2\n"), "O1:\n\n#1 := 1\n");
    EXPECT_EQ(programs_of("%TITLE OF THE TAPE\nO1\n#1=1\n%"), "O1:\n\n#1 := 1\n");
    EXPECT_EQ(programs_of("#1=1\n#2=2\n"), "O1:\n#1 := 1\n#2 := 2\n");
    EXPECT_EQ(programs_of("O5\n#1=1\n%\n#2=2"), "O5:\n\n#1 := 1\n");
}

TEST(FanucSplitter, AProgramNumberGluedToTheEndOfAProgramBeginsTheNextOne) {
    EXPECT_THAT(blocks_of("M99O0810(Z)\nN5 M30O20\nM2O3"),
                ElementsAre("M99", "O0810(Z)", "N5 M30", "O20", "M2", "O3"));
    EXPECT_THAT(blocks_of("M99P120O7"), ElementsAre("M99P120", "O7"));
    EXPECT_EQ(programs_of("O1\n#1=1\nM99O2(NEXT)\n#1=2\nM99\n"),
              "O1:\n\n#1 := 1\nreturn\nO2:\n\n#1 := 2\nreturn\n");
}

TEST(FanucSplitter, BlanksAndCommentsBeforeTheNextProgramMeanNothing) {
    EXPECT_THAT(blocks_of("M99 O0810(Z)\nm30\tO 20\nM 2 (A) (B) O3\nM99(A)O4"),
                ElementsAre("M99", "O0810(Z)", "m30", "O 20", "M 2 (A) (B)", "O3", "M99(A)", "O4"));
    EXPECT_THAT(blocks_of("M99 P 120 O7"), ElementsAre("M99 P 120", "O7"));
    const std::string good = programs_of("O1\n#1=1\nM99O2(NEXT)\n#1=2\nM99\n");
    EXPECT_EQ(programs_of("O1\n#1=1\nM99 O2(NEXT)\n#1=2\nM99\n"), good);
}

TEST(FanucSplitter, WhereAControlStopsAtItNoProgramBeginsInABlock) {
    RawBlock block;
    const std::string_view text = "M99O2";
    cut_block(text, 0, Reading::stops, block);
    EXPECT_EQ(block.span.end, text.size());
    for (const ControlModel& control : fanuc_controls())
        EXPECT_NE(program_behind_end(control), Reading::stops) << control.name;
}

TEST(FanucSplitter, OtherBlocksKeepTheirProgramNumber) {
    EXPECT_THAT(blocks_of("M98O2\nM199O2\nX99 O2\nX30O2\nM30(O2)\nM99OX\nM30 X O2"),
                ElementsAre("M98O2", "M199O2", "X99 O2", "X30O2", "M30(O2)", "M99OX", "M30 X O2"));
}

TEST(FanucTape, ProgramsAfterAMarkAreReadWhenAnotherMarkFollows) {
    EXPECT_EQ(programs_of("%\nO1\n#1=1\n%\nO2\n#2=2\n%\n"), "O1:\n\n#1 := 1\nO2:\n\n#2 := 2\n");
    EXPECT_EQ(programs_of("%\nO1\n#1=1\n%\nTEXT\n%\nO2\n#2=2\n%\n"), "O1:\n\n#1 := 1\nO2:\n\n#2 := 2\n");
}

TEST(FanucTape, AProgramAfterNoiseIsReadWhateverMarksTheNoiseHolds) {
    const std::string good = "O1:\n\n#1 := 1\nO2:\n\n#2 := 2\n";
    EXPECT_EQ(programs_of("%\nO1\n#1=1\n%\n$?}X\n%\n%\n{Z~\nO2 (TWO)\n#2=2\n%\n"), good);
    EXPECT_EQ(programs_of("%\nO1\n#1=1\n%\n$?}X\nO2\n#2=2\n"), good);
    EXPECT_EQ(programs_of("%\nO1\n#1=1\n%\nO2 IS FOR MONDAY\n#2=2\n"), "O1:\n\n#1 := 1\n");
}

TEST(FanucTape, PercentInACommentIsNoMark) {
    EXPECT_EQ(programs_of("O1(80% OVERRIDE)\n#1=1 (100%)\n#2=2"), "O1:\n\n#1 := 1\n#2 := 2\n");
}

TEST(FanucTape, ByteOrderMarkIsPassedOver) {
    EXPECT_EQ(programs_of("\xEF\xBB\xBF%\nO1\n#1=1\n%"), "O1:\n\n#1 := 1\n");
    EXPECT_EQ(programs_of("\xEF\xBB\xBFO1\n#1=1\n"), "O1:\n\n#1 := 1\n");
}

TEST(FanucProgramHead, IsANumberOrANameAtTheHeadOfABlock) {
    const auto head = [](std::string_view text) {
        const auto found = find_program_head(text, {0, static_cast<Offset>(text.size())});
        return found ? found->name : std::string();
    };
    EXPECT_EQ(head("O9010(DRILL)"), "O9010");
    EXPECT_EQ(head("o 12"), "O12");
    EXPECT_EQ(head(":1234"), "O1234");
    EXPECT_EQ(head("O<PART 1>"), "<PART 1>");
    EXPECT_EQ(head("<PART>"), "<PART>");
    EXPECT_EQ(head("N10 O12"), "");
    EXPECT_EQ(head("O#1"), "");
    EXPECT_EQ(head("<PART"), "");
}

} // namespace
} // namespace maclint::fanuc
