//! What people read: code frames, notes, paths, the summary.
#include "cli/report/snippet.hpp"
#include "tests/cli/reports.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint::cli {
namespace {

using test::HandMade;
using testing::HasSubstr;
using testing::Not;
using testing::SizeIs;

constexpr TextStyle plain{Colour::plain, Summary::at_the_end};

/// Text and marks of the only line.
std::string line_of(const std::string& text, Span span) {
    const auto lines = frame_of(Source::from_bytes("a.nc", text), span);
    return lines.size() == 1 ? lines[0].text + "\n" + lines[0].marks : "not one line";
}

TEST(Frame, MarksAPartOfALine) { EXPECT_EQ(line_of("O1\n  GOTO 20\nM30", {5, 12}), "  GOTO 20\n  ^^^^^^^"); }

TEST(Frame, ExpandsTabs) { EXPECT_EQ(line_of("\tX1\tY2", {4, 6}), "    X1  Y2\n        ^^"); }

TEST(Frame, CountsWideCharactersTwiceAndCombiningOnesNot) {
    EXPECT_EQ(line_of("(中文) X1", {9, 11}), "(中文) X1\n       ^^");
    EXPECT_EQ(line_of("(e\xCC\x81) X1", {6, 8}), "(e\xCC\x81) X1\n    ^^");
}

TEST(Frame, MarksTheCharacterThatACombiningOneSitsOn) {
    const std::string grave = "\xCC\x80";
    EXPECT_EQ(line_of("X1 e" + grave + " Y", {4, 6}), "X1 e" + grave + " Y\n   ^");
    EXPECT_EQ(line_of("X1 e" + grave + grave + " Y", {6, 8}), "X1 e" + grave + grave + " Y\n   ^");
    EXPECT_EQ(line_of("X1 e" + grave + " Y", {4, 8}), "X1 e" + grave + " Y\n   ^^^");
    EXPECT_EQ(line_of(grave + "X1", {0, 2}), grave + "X1\n^") << "nothing stands before it";
    EXPECT_EQ(line_of(grave, {0, 2}), grave + "\n^");
}

TEST(TextReport, IsWrittenThoughAMarkedCharacterTakesNoColumn) {
    HandMade made("O1.nc", "O1\nG0 X1. \xCC\x80\nM30\n");
    made.add("\xCC\x80", Severity::error);
    const std::string text = write_text(made.report(), plain);
    EXPECT_THAT(text, HasSubstr(" 2 | G0 X1. \xCC\x80\n   |       ^\n"));
}

TEST(Frame, ShowsTextOfOtherEncodingsAsUtf8) { EXPECT_EQ(line_of("(\xF6) X1", {4, 6}), "(ö) X1\n    ^^"); }

TEST(Frame, EscapesWhatATerminalWouldActOn) {
    EXPECT_EQ(line_of("(\x1B[2J) X1", {7, 9}), "(\\x1B[2J) X1\n          ^^");
}

TEST(Frame, MarksAnEmptyPlaceAndTheEndOfALineWithOneCaret) {
    EXPECT_EQ(line_of("G0 X1\n", {3, 3}), "G0 X1\n   ^");
    EXPECT_EQ(line_of("G0 X1\n", {5, 5}), "G0 X1\n     ^");
    EXPECT_EQ(line_of("", {0, 0}), "\n^");
}

TEST(Frame, CutsALongLineAroundTheMarks) {
    const std::string text = std::string(500, 'X') + "GOTO 9" + std::string(500, 'Y');
    const auto lines = frame_of(Source::from_bytes("a.nc", text), {500, 506});
    ASSERT_THAT(lines, SizeIs(1));
    EXPECT_THAT(lines[0].text, HasSubstr("XGOTO 9Y"));
    EXPECT_LT(lines[0].text.size(), 130U);
    EXPECT_EQ(lines[0].marks.find('^'), 31U);
}

TEST(Frame, ShowsTheFirstAndTheLastOfManyLines) {
    const std::string text = "L1\n  L2\n  L3\nL4\nL5\nL6\n";
    const auto lines = frame_of(Source::from_bytes("a.nc", text), {0, 22});
    ASSERT_THAT(lines, SizeIs(4));
    EXPECT_EQ(lines[1].marks, "  ^^");
    EXPECT_EQ(lines[2].number, 0U);
    EXPECT_EQ(lines[3].number, 6U);
}

TEST(TextReport, ShowsMessagePlaceFrameAndNotes) {
    HandMade made("O9100.nc", "O9100\nGOTO 20\nWHILE [#1 LT 5] DO1\nN20 G0\nEND1\nM30\n");
    Finding& finding = made.add("GOTO 20", Severity::error);
    finding.related.push_back({made.source(), made.place_of("N20"), "N20 is here"});
    EXPECT_EQ(write_text(made.report(), plain),
              "error[MAC002]: There is no rule 'GOTO 20'. See 'maclint rules' for the list.\n"
              "  --> O9100.nc:2:1\n"
              "   |\n"
              " 2 | GOTO 20\n"
              "   | ^^^^^^^\n"
              "note: N20 is here\n"
              "  --> O9100.nc:4:1\n"
              "   |\n"
              " 4 | N20 G0\n"
              "   | ^^^\n"
              "\n"
              "1 error in 1 file (1 checked)\n");
}

TEST(TextReport, NumbersTheStepsOfAPathAndLeavesTheMiddleOfALongOneOut) {
    HandMade made("O1.nc", "O1\nM30\n");
    Finding& finding = made.add("M30", Severity::warning);
    for (int i = 0; i < 30; ++i) finding.path.push_back({made.source(), {0, 2}, "here"});
    const std::string text = write_text(made.report(), plain);
    EXPECT_THAT(text, HasSubstr("note: step 6 of 30: here"));
    EXPECT_THAT(text, HasSubstr("note: 18 steps left out"));
    EXPECT_THAT(text, Not(HasSubstr("step 7 of")));
    EXPECT_THAT(text, HasSubstr("note: step 25 of 30: here"));
}

TEST(TextReport, SumsUp) {
    HandMade made("O1.nc", "O1\nM30\n");
    EXPECT_EQ(write_text(made.report(), plain), "no findings (1 checked)\n");
    made.add("O1", Severity::error);
    made.add("M30", Severity::warning);
    made.add("M30", Severity::warning);
    made.report().findings.push_back(made.report().findings.back());
    made.report().findings.back().suppressed = Suppression{{0, 2}, "WANTED"};
    EXPECT_EQ(summary_line(made.report()),
              "1 error, 2 warnings in 1 file (1 checked, 1 allowed by comments)");
    EXPECT_THAT(write_text(made.report(), {Colour::plain, Summary::left_out}), Not(HasSubstr("checked")));
}

TEST(TextReport, IsColouredOnlyWhenAsked) {
    HandMade made("O1.nc", "O1\nM30\n");
    made.add("M30", Severity::error);
    EXPECT_THAT(write_text(made.report(), plain), Not(HasSubstr("\x1B")));
    EXPECT_THAT(write_text(made.report(), {Colour::coloured, Summary::left_out}),
                HasSubstr("\x1B[1;31merror[MAC002]\x1B[0m"));
}

TEST(TextReport, EscapesTextOfTheProgramAndOfFileNames) {
    HandMade made("O1\x1B[31m.nc", "O1\n(\x1B[2J\x07)\nM30\n");
    made.add("\x1B[2J", Severity::error);
    for (const std::string& text : {write_text(made.report(), plain), write_concise(made.report(), plain)}) {
        EXPECT_THAT(text, Not(HasSubstr("\x1B")));
        EXPECT_THAT(text, Not(HasSubstr("\x07")));
        EXPECT_THAT(text, HasSubstr("O1\\x1B[31m.nc"));
    }
}

TEST(ConciseReport, WritesOneLineAFinding) {
    HandMade made("a/O1.nc", "O1\n(\xC3\xB6) M30\n");
    made.add("M30", Severity::note);
    EXPECT_EQ(write_concise(made.report(), plain),
              "a/O1.nc:2:5: note[MAC002] There is no rule 'M30'. See 'maclint rules' for the list.\n"
              "1 note in 1 file (1 checked)\n");
}

} // namespace
} // namespace maclint::cli
