//! Reports are told by their whole text; what only looks like one is a program.
#include "analyzer/dialect/dialect.hpp"
#include "cli/input/own_report.hpp"
#include "cli/report/report.hpp"
#include "cli/report/statistics.hpp"
#include "cli/report/timing.hpp"
#include "rules/rule.hpp"
#include "tests/cli/reports.hpp"
#include "tests/support/in_repository.hpp"
#include "tests/support/lines.hpp"
#include "tests/support/linted.hpp"

#include <iterator>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint::cli {
namespace {

using test::HandMade;
using testing::AllOf;
using testing::HasSubstr;

/// What is found in one text, as the command has it before it writes.
Report report_on(std::string_view dialect, const std::string& text) {
    Overrides overrides;
    overrides.dialect = find_dialect(dialect);
    Result result = test::lint_texts({{"mill/O1 (2).nc", text}}, overrides);
    Report report;
    report.findings = std::move(result.findings);
    report.notices = std::move(result.notices);
    report.files = std::move(result.sources);
    return report;
}

/// All that the formats for people and for GitHub make of it.
std::vector<std::string> written(Report report) {
    std::vector<std::string> texts;
    for (const bool statistics : {false, true}) {
        report.statistics = statistics;
        for (const Summary summary : {Summary::at_the_end, Summary::left_out})
            for (const Colour colour : {Colour::plain, Colour::coloured})
                for (const PathDetail path : {PathDetail::none, PathDetail::shortened, PathDetail::full}) {
                    for (const std::size_t width : {least_width, std::size_t{67}, usual_width, most_width})
                        texts.push_back(write_text(report, {colour, summary, path, width}));
                    texts.push_back(write_concise(report, {colour, summary, path, usual_width}));
                    texts.push_back(write_github(report, {colour, summary, path, usual_width}));
                }
    }
    std::erase(texts, "");
    return texts;
}

TEST(OwnReport, IsKnownWhateverTheFinding) {
    for (const Rule* rule : all_rules())
        for (const Example& example : rule->bad)
            for (const std::string& text : written(report_on(example.dialect, std::string(example.text))))
                ASSERT_TRUE(is_own_report(text)) << rule->code << "\n" << text;
}

/// Every form that a report has, once.
std::string text_report() {
    HandMade made("O1.nc", "%\nO1\nS200\nIF[#1EQ1]GOTO4\nGOTO 4\n" + std::string(120, '\n') + "N4 M99\n%\n");
    Finding& finding = made.add("GOTO 4", Severity::warning);
    finding.arguments = {std::string("words that go on ") + std::string(60, 'a') +
                         " and on over three lines " + std::string(50, 'b')};
    finding.path = {{made.source(), made.place_of("S200"), "S is set here"},
                    {made.source(), finding.span, "it is here"}};
    finding.related = {{made.source(), made.place_of("M99"), "the macro returns"}};
    const HandMade other("O2.nc", "O2\nG65 P1\n");
    made.add("%", Severity::error).related = {{other.source(), other.place_of("G65"), "called from here"}};
    made.report().statistics = true;
    return write_text(made.report(), {.path = PathDetail::none}) +
           write_text(made.report(), {.path = PathDetail::full, .width = least_width});
}

TEST(OwnReport, IsKnownWhenItsEndIsMissingBehindAPlace) {
    const std::string report = text_report();
    ASSERT_TRUE(is_own_report(report));
    std::string text;
    bool has_place = true; // the last headline
    for (const std::string& line : test::lines_of(report)) {
        text += line + "\n";
        has_place = line.find("--> ") != std::string::npos || (has_place && line.find("]: ") > line.size());
        EXPECT_EQ(is_own_report(text), has_place) << text;
    }
}

TEST(OwnReport, IsKnownAfterWhatToolsDoToTextFiles) {
    std::string windows = "\xEF\xBB\xBF";
    for (const char c : text_report()) windows += c == '\n' ? "\r\n" : std::string(1, c);
    EXPECT_TRUE(is_own_report(windows));
    EXPECT_TRUE(is_own_report(text_report() + "\n" + text_report())); // appended
}

TEST(OwnReport, IsKnownWithWhatWentToStandardError) {
    EXPECT_TRUE(is_own_report("maclint: note: part.mpf: this is not linted.\n"));
    EXPECT_TRUE(
        is_own_report("maclint: error: O1.nc: cannot be read.\n" + text_report() + write_timing({}, {})));
    EXPECT_TRUE(is_own_report("no new findings (1 checked, 2 files with other names passed over)\n"
                              "12 known findings of base.json not shown\n"));
}

TEST(OwnReport, IsNoneWithALineOfAProgramAnywhere) {
    const std::vector<std::string> lines = test::lines_of(text_report());
    for (const char* line : {"%", "O1", "GOTO 99", "N10 G0 X1. (error[MAC301])", "(O1)", " %", "    %", "/M1",
                             "#1=2", "1 | GOTO 99", "N1 | X1."}) {
        for (std::size_t at = 0; at <= lines.size(); ++at) {
            std::string text;
            for (std::size_t i = 0; i <= lines.size(); ++i) {
                if (i == at) text += std::string(line) + "\n";
                if (i < lines.size()) text += lines[i] + "\n";
            }
            EXPECT_FALSE(is_own_report(text)) << text;
        }
    }
}

/// A finding in a line of a program.
std::string row_with(const std::string& code) {
    return "error[MAC301]: Missing label: 'X'.\n  --> a:1:1\n 1 | " + code + "\n   | ^\n";
}

TEST(OwnReport, QuotesTapeMarksInRows) {
    for (const char* code : {"%", "G0;%", "G0;%;O1;GOTO7;M30;"}) EXPECT_TRUE(is_own_report(row_with(code)));
}

TEST(OwnReport, IsNoneThatAControlCouldRun) {
    const std::string finding = "O1.nc:4:1: error[MAC301] Missing label: 'X'.";
    const std::vector<std::string> texts = {
        "\n", " ", "%\nO1\nGOTO7\nM30\n%\n", finding + "\n%\nO1\nGOTO7\nM30\n%\n",
        "maclint: note: this is not linted.\n%\nO1\nGOTO7\nM30\n%\n",
        "no findings (3 checked)\n%\nO1\nGOTO7\nM30\n%\n", "%\nO1\nGOTO7\nM30\n%\n" + finding + "\n",
        "O1\n" + finding + "\nGOTO7\nM30\n",
        // line ends of other kinds, and blocks that a line end is not wanted for
        finding + "\rO1\rGOTO7\rM30\r", finding + "\x0B%\x0BO1", finding + ";%;O1;GOTO7;M30", finding + " %",
        // every line is a finding to whoever does not know comments
        "%(" + finding + ")\nO1(" + finding + ")\nGOTO7(" + finding + ")\n",
        "GOTO7 (" + finding + ")\nM30 (" + finding + ")\n", "N1 M30 [" + finding + "]\n",
        // a message is not wrapped before there is need to
        "error[MAC301]: Missing label: 'X'.\n    %\n    O1\n    GOTO7\n    M30\n    %\n",
        "error[MAC301]: Missing label: 'X'.\n    O1\n    GOTO7\n  --> a.nc:1:1\n",
        "error[MAC301]: " + std::string(70, 'a') + "\n    % " + std::string(70, 'a') + "\n    O1\n",
        // a row is one of a finding
        " 1 | GOTO7\n", row_with("G0;%;O1;GOTO7;M30;" + std::string(110, 'X')), finding + "\n 1 | GOTO7\n",
        "  3  GOTO7\n", "(BORES) (4 checked)\nO3\n"};
    for (const std::string& text : texts) EXPECT_FALSE(is_own_report(text)) << text;
}

/// Each line of it is written as the writers write.
const std::vector<std::string> lines_of_reports = {
    "timing: finding files       0.012 s", "timing: reading             0.012 s  1 file, 0.02 MB",
    "timing: analysis           10.500 s  3 programs",
    "timing: rules   1.000 s  2 paths looked for, 0 given up", "maclint: error: O1.nc: cannot be read.",
    "a.nc:1:1: error[MAC301] Missing label: 'X;' is nowhere.",
    "::notice file=a%3B.nc,line=1,endLine=1,col=1,endColumn=2,title=MAC301 jump-target-missing::Missing",
    "::warning file=a.nc,line=1,endLine=2,title=MAC301 jump-target-missing::Missing",
    "::error title=maclint,file=a.nc::cannot be read.",
    // NOLINTNEXTLINE(bugprone-suspicious-missing-comma): one line of a report, too long for one here
    "no findings (1 checked, 2 allowed by comments, 1 file with another name passed over, 2 programs ignored "
    "by "
    "git, 1 link to elsewhere not followed, 3 not shown: see --max-findings)",
    "3 steps of paths not shown; --path full shows them",
    "findings by rule:\n  10  MAC301 jump-target-missing (error)\nfindings by file:\n   9  a.nc\n   1  b.nc",
    "findings by rule:\n  none\nfindings by file:\n  none",
    "error[MAC301]: Missing label: 'X'.\n  --> a.nc:1:1"};

TEST(OwnReport, HasLinesAsTheWritersWriteThem) {
    for (const std::string& text : lines_of_reports) EXPECT_TRUE(is_own_report(text + "\n")) << text;
}

TEST(OwnReport, IsNoneWhereALineIsOnlyLikeIt) {
    const std::vector<std::string> texts = {
        "timing: ;O1;G0X100.;M30", "timing: G0X100.", "timing: reports   0.012 s  G0X100.",
        "timing: reading  0.012 s  G0X100.", "timing: finding files  .012 s",
        "maclint: error: ;O1;G0X100.;M30", "maclint: note: G0X100.", "maclint: note: O1;.",
        "maclint: note: O1",
        "error[MAC303]: " + std::string(70, 'J') + "\n    G0X100" + std::string(68, ' ') + "M3",
        "error[MAC303]: " + std::string(70, 'J') + "\n  --> a.nc:1:1", // not the rule's words
        "error[MAC301]: Missing label: 'X'.", "error[MAC301]: Missing label: 'X'.\n    G0X100",
        "error[MAC999]: Missing label: 'X'.\n  --> a.nc:1:1",
        "error[MAC301]: Missing label: 'X'.\n  --> ;O1:1:1", "a.nc:1:1: error[MAC999] Missing",
        "a.nc:1:1: error[MAC301] G0X100", "a.nc:1:1: error[MAC301] Missing label: 'X'.;O1;G0X100.;M30",
        ";O1;a.nc:1:1: error[MAC301] Missing label: 'X'.", "::error file=x", "::error file=x;O1;G0X100.;M30",
        "::error title=maclint;O1;G0X1.", "::error file=a.nc,line=1,endLine=1,title=MAC301 G0X100::Missing",
        "::error file=a.nc,line=1,endLine=1,title=MAC301 jump-target-missing::;O1;G0X1.",
        "no findings (1 checked, G0X100.)", "no findings (1 checked, G0X100. checked)",
        "1 known finding of ;O1;G0X100. not shown", "findings by rule:\n  1  G0X100",
        "findings by file:\n  1  G0X100", "findings by rule:\n  none\nfindings by file:\n  1  G0X100",
        "findings by rule:\n  1  MAC301 jump-into-loop (error)",
        // NOLINTNEXTLINE(bugprone-suspicious-missing-comma)
        "findings by rule:\n  1  MAC301 jump-target-missing (error)\nfindings by file:\n  1  a.nc\n  100  "
        "G0X100",
        "findings by rule:\n  1  MAC301 jump-target-missing (error)\nfindings by file:\n  1  ;O1;G0X100"};
    for (const std::string& text : texts) EXPECT_FALSE(is_own_report(text + "\n")) << text;
}

class OwnReports : public test::InRepository {};

TEST_F(OwnReports, ThatArePassedOverAreNoted) {
    folder.write("O1.nc", test::with_defect);
    ASSERT_EQ(run({"O1.nc", "--output", "text:report.txt"}).status, 1);
    ASSERT_EQ(run({"O1.nc", "--output", "concise:sub/report"}).status, 2); // there is no such folder
    folder.write("sub/O2.nc", "maclint: note: O1.nc: this is not linted.\n");
    EXPECT_THAT(run({"report.txt"}).err,
                HasSubstr("maclint: note: report.txt: this is not linted: a report of maclint."));
    EXPECT_THAT(
        run({"."}).err,
        HasSubstr("maclint: note: .: 2 files are not linted: a report of maclint (report.txt and others)."));
    EXPECT_THAT(run({"sub"}).err, HasSubstr("O2.nc: this is not linted: a report of maclint."));
}

TEST_F(OwnReports, ThatAreNamedAsProgramsAreFindings) {
    folder.write("O2.nc", "O1.nc:4:1: error[MAC301] Missing label: 'X'.\n");
    const test::Finished finished = run({"O2.nc", "--format", "concise"});
    EXPECT_EQ(finished.status, 1);
    EXPECT_THAT(finished.out, HasSubstr("error[MAC003] Not an NC program but a report of maclint."));
}

TEST_F(OwnReports, OfWhichAProgramHasOnlyALineAreLintedAsPrograms) {
    const std::string program(test::with_defect);
    const std::string line = "a.nc:1:1: error[MAC301] Missing label: 'X'.\n";
    for (const std::string& text :
         {line + program, program + line, "maclint: note: this is not linted.\n" + program}) {
        folder.write("O1.nc", text);
        for (const char* path : {".", "O1.nc"}) {
            const test::Finished finished = run({path, "--format", "concise"});
            EXPECT_EQ(finished.status, 1) << text;
            EXPECT_THAT(finished.out, AllOf(HasSubstr("error[MAC301]"), HasSubstr("(1 checked)"))) << text;
        }
        EXPECT_EQ(run({".", "--output", "json:O1.nc"}).status, 2) << text; // no report goes over it
    }
}

TEST_F(OwnReports, WhoseTableAProgramBeginsLikeIsNotWrittenOver) {
    const std::string text = "findings by rule:\n  1  G0X100\n  2  M30\n";
    folder.write("O1.nc", text);
    EXPECT_THAT(run({"."}).out, HasSubstr("(1 checked"));
    folder.write("O2.nc", test::with_defect);
    EXPECT_EQ(run({"O2.nc", "--output", "json:O1.nc"}).status, 2);
    EXPECT_EQ(test::read_file(folder.path() / "O1.nc"), text);
}

} // namespace
} // namespace maclint::cli
