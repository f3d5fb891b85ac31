//! What people read: code frames, notes, paths, the summary.
#include "cli/report/columns.hpp"
#include "cli/report/limit.hpp"
#include "cli/report/snippet.hpp"
#include "tests/cli/reports.hpp"

#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint::cli {
namespace {

using test::HandMade;
using testing::ElementsAre;
using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;

constexpr TextStyle plain{Colour::plain, Summary::at_the_end};

constexpr std::size_t wide = 110;

/// Text and marks of a line.
std::string line_of(const std::string& text, Span span) {
    const CodeLine line = code_line(Source::from_bytes("a.nc", text), span, wide);
    return line.text + "\n" + line.marks;
}

TEST(Frame, MarksAPartOfALineWithoutItsIndent) {
    EXPECT_EQ(line_of("O1\n  GOTO 20\nM30", {5, 12}), "GOTO 20\n^^^^^^^");
}

TEST(Frame, ExpandsTabs) { EXPECT_EQ(line_of("\tX1\tY2", {4, 6}), "X1  Y2\n    ^^"); }

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

TEST(TextReport, TellsAHabitInFullThreeTimesAndThenListsItsPlaces) {
    const auto written = [](Severity severity, PathDetail path) {
        HandMade made("O1.nc", "O1\nG0 X1.\nG0 X2.\nG0 X3.\nG0 X4.\nG0 X5.\nM30\n");
        for (const char* place : {"X1.", "X2.", "X3.", "X4.", "X5."}) made.add(place, severity);
        return write_text(made.report(), {.path = path});
    };
    const std::string habit = written(Severity::warning, PathDetail::shortened);
    EXPECT_THAT(habit, HasSubstr("The same in 2 more places; --path full shows all.\n"
                                 "  O1.nc:5:4\n  O1.nc:6:4\n"));
    EXPECT_THAT(habit, HasSubstr("4 | G0 X3."));
    EXPECT_THAT(habit, Not(HasSubstr("5 | G0 X4.")));
    EXPECT_THAT(written(Severity::warning, PathDetail::full), HasSubstr("6 | G0 X5."));
    EXPECT_THAT(written(Severity::error, PathDetail::shortened), HasSubstr("6 | G0 X5."));
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
    const CodeLine line = code_line(Source::from_bytes("a.nc", text), {500, 506}, 40);
    EXPECT_THAT(line.text, HasSubstr("XGOTO 9Y"));
    EXPECT_EQ(columns_of(line.text), 40U);
    EXPECT_EQ(columns_of(line.text.substr(0, line.text.find("GOTO"))), line.marks.find('^'));
    EXPECT_EQ(line.marks.size() - line.marks.find('^'), 6U);
}

TEST(Frame, CutsALongLineAtItsEndWhenThatIsMeant) {
    const std::string text = std::string(500, 'X') + "GOTO";
    const CodeLine line = code_line(Source::from_bytes("a.nc", text), {504, 504}, 40);
    EXPECT_TRUE(line.text.starts_with("…X"));
    EXPECT_TRUE(line.text.ends_with("XGOTO"));
    EXPECT_EQ(line.marks, std::string(columns_of(line.text), ' ') + "^");
}

TEST(Frame, LooksAtNoMoreOfALineThanItShows) {
    // Wide enough that a look at the whole line for each of its blocks would take a minute.
    std::string text;
    while (text.size() < 50'000) text += "G1 X1.;";
    const Source source = Source::from_bytes("a.nc", text);
    for (Offset at = 0; at + 7 < text.size(); at += 7) {
        const CodeLine line = code_line(source, {at, at + 2}, 40);
        ASSERT_LE(columns_of(line.text), 40U);
        ASSERT_EQ(line.marks.size() - line.marks.find('^'), 2U);
    }
}

TEST(Frame, ShowsWhereASpanOfManyLinesBegins) { EXPECT_EQ(line_of("L1\n  L2\nL3\n", {1, 9}), "L1\n ^"); }

TEST(Columns, TextIsWrappedBetweenWords) {
    EXPECT_THAT(wrapped("one two three", 3, 9), ElementsAre("one", "two three"));
    EXPECT_THAT(wrapped("one two three", 9, 5), ElementsAre("one two", "three"));
    EXPECT_THAT(wrapped("a unbreakable b", 4, 4), ElementsAre("a", "unbreakable", "b"));
    EXPECT_THAT(wrapped("中文 中", 4, 4), ElementsAre("中文", "中"));
    EXPECT_THAT(wrapped("", 4, 4), ElementsAre(""));
}

TEST(TextReport, ShowsMessagePlaceAndRows) {
    HandMade made("O9100.nc", "O9100\n  GOTO 20\nWHILE [#1 LT 5] DO1\nN20 G0\nEND1\nM30\n");
    Finding& finding = made.add("GOTO 20", Severity::error);
    finding.related.push_back({made.source(), made.place_of("N20"), "N20 is here"});
    EXPECT_EQ(write_text(made.report(), plain),
              "error[MAC002]: Unknown rule: there is no 'GOTO 20'.\n"
              "  --> O9100.nc:2:3\n"
              " 2 | GOTO 20\n"
              "   | ^^^^^^^\n"
              " 4 | N20 G0      N20 is here\n"
              "   = cure: See 'maclint rules' for the list.        more: maclint explain MAC002\n"
              "\n"
              "1 error in 1 file (1 checked)\n");
}

/// A finding at 'GOTO 4' with a path from line 2 over 3, and what happens on line 5 after it.
HandMade with_path() {
    HandMade made("O1.nc", "O1\nS200\nIF[#1EQ1]GOTO4\nGOTO 4\nN4 M99\n");
    Finding& finding = made.add("GOTO 4", Severity::warning);
    finding.path = {{made.source(), made.place_of("S200"), "S is set here"},
                    {made.source(), made.place_of("#1EQ1"), "false"},
                    {made.source(), finding.span, "it is here"}};
    finding.related = {{made.source(), made.place_of("M99"), "the macro returns"}};
    return made;
}

std::string rows_in(HandMade made, PathDetail detail) {
    const std::string text = write_text(made.report(), {.path = detail});
    const auto begin = text.find(" 4 |") == std::string::npos ? 0 : text.find('\n', text.find("-->")) + 1;
    return text.substr(begin, text.find("   =") - begin);
}

TEST(TextReport, HasOneRowForEachLineInTheOrderOfThePath) {
    EXPECT_EQ(rows_in(with_path(), PathDetail::full), " 2 | S200             S is set here\n"
                                                      " 3 | IF[#1EQ1]GOTO4   false\n"
                                                      " 4 | GOTO 4           it is here\n"
                                                      "   | ^^^^^^\n"
                                                      " 5 | N4 M99           the macro returns\n");
    EXPECT_EQ(rows_in(with_path(), PathDetail::shortened), rows_in(with_path(), PathDetail::full));
}

TEST(TextReport, JoinsWhatIsSaidOfOneLine) {
    HandMade made = with_path();
    Finding& finding = made.report().findings.front().finding;
    finding.path.insert(finding.path.begin() + 2, {made.source(), made.place_of("GOTO4"), "seen"});
    EXPECT_THAT(rows_in(std::move(made), PathDetail::full), HasSubstr(" 3 | IF[#1EQ1]GOTO4   false; seen\n"));
}

TEST(TextReport, ShowsNoPathWhenNoneIsWanted) {
    EXPECT_EQ(rows_in(with_path(), PathDetail::none), " 4 | GOTO 4      it is here\n   | ^^^^^^\n");
}

TEST(TextReport, NamesTheFileOfARowThatStandsElsewhere) {
    HandMade made("O1.nc", "O1\nM30\n");
    const HandMade other("O2.nc", "O2\nG65 P1\n");
    made.add("M30", Severity::warning).related = {
        {other.source(), other.place_of("G65"), "called from here"}};
    EXPECT_THAT(write_text(made.report(), plain),
                HasSubstr("   | ^^^\n  ::: O2.nc:2:1\n 2 | G65 P1      called from here\n"));
}

TEST(TextReport, ShortensALongPathAndCountsWhatIsNotShown) {
    std::string text = "O1\n";
    for (int i = 0; i < 30; ++i) text += "G" + std::to_string(10 + i) + "\n";
    HandMade made("O1.nc", text + "M30\n");
    Finding& finding = made.add("M30", Severity::warning);
    for (int i = 0; i < 30; ++i) {
        const std::string block = "G" + std::to_string(10 + i);
        finding.path.push_back({made.source(), made.place_of(block), "step " + std::to_string(i)});
    }
    finding.path.push_back({made.source(), finding.span, "end"});
    const std::string shortened = write_text(made.report(), plain);
    EXPECT_THAT(shortened, HasSubstr("step 0\n"));
    EXPECT_THAT(shortened, HasSubstr("step 29\n"));
    EXPECT_THAT(shortened, Not(HasSubstr("step 1\n")));
    EXPECT_THAT(shortened, EndsWith("\n27 steps of paths not shown; --path full shows them\n"));
    const std::string full = write_text(made.report(), {.path = PathDetail::full});
    EXPECT_THAT(full, HasSubstr("step 15\n"));
    EXPECT_THAT(full, Not(HasSubstr("not shown")));
}

TEST(TextReport, IsNoWiderThanItsWidth) {
    HandMade made = with_path();
    Finding& finding = made.report().findings.front().finding;
    finding.arguments = {std::string(60, 'a') + " " + std::string(30, 'b')};
    finding.path.front().text = "a remark with many words that has no room beside the code of its line";
    std::istringstream lines(write_text(made.report(), plain));
    for (std::string line; std::getline(lines, line);) EXPECT_LE(columns_of(line), usual_width) << line;
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

/// Codes of the findings' severities, in the order of the report.
std::string severities(const Report& report) {
    std::string codes;
    for (const FilteredFinding& filtered : report.findings)
        codes += filtered.suppressed ? 's' : name_of(filtered.finding.severity).front();
    return codes;
}

TEST(Limit, LeavesTheMostSevereInTheirOrder) {
    HandMade made("O1.nc", "O1\nM30\n");
    for (const Severity severity : {Severity::note, Severity::warning, Severity::error, Severity::warning,
                                    Severity::error, Severity::note})
        made.add("M30", severity);
    made.report().findings.front().suppressed = Suppression{{0, 2}, "WANTED"};
    limit(made.report(), 3);
    EXPECT_EQ(severities(made.report()), "swee");
    EXPECT_EQ(made.report().not_shown.size(), 2U);
    limit(made.report(), 0);
    EXPECT_EQ(severities(made.report()), "s");
}

TEST(Limit, ATerminalOfTooManyFindingsGetsTheErrorsFirst) {
    HandMade made("O1.nc", "O1\nM30\n");
    made.add("M30", Severity::warning);
    made.add("M30", Severity::error);
    fit_terminal(made.report());
    EXPECT_EQ(severities(made.report()), "we");
    for (std::size_t i = 0; i < most_on_terminal; ++i) made.add("M30", Severity::warning);
    fit_terminal(made.report());
    EXPECT_EQ(severities(made.report()), "e" + std::string(most_on_terminal - 1, 'w'));
    EXPECT_THAT(summary_line(made.report()), HasSubstr("1 error, 101 warnings"));
    EXPECT_THAT(summary_line(made.report()), HasSubstr("2 not shown: see --max-findings"));
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
              "a/O1.nc:2:5: note[MAC002] Unknown rule: there is no 'M30'. See 'maclint rules' for the list.\n"
              "1 note in 1 file (1 checked)\n");
}

} // namespace
} // namespace maclint::cli
