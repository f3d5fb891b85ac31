//! Findings of rows: every report names the row, so that its name can be copied from there.
#include "cli/input/own_report.hpp"
#include "cli/report/fingerprint.hpp"
#include "cli/report/report.hpp"
#include "cli/report/statistics.hpp"
#include "rules/words/rule_row.hpp"
#include "tests/cli/reports.hpp"

#include <algorithm>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace maclint::cli {
namespace {

using nlohmann::json;
using test::HandMade;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

void add(HandMade& made, std::string_view part, std::string_view row_name) {
    const RuleRow* row = find_rule_row(row_name);
    ASSERT_NE(row, nullptr) << row_name;
    Finding& finding = made.add(part, Severity::warning);
    finding.rule = row->rule;
    finding.row = row;
    finding.message_id = "missing";
    finding.arguments = {"G83", "Q (depth of a peck)", "the control stops", "Q"};
}

/// Two rows of one rule at a block, and a rule without rows.
HandMade drilling() {
    HandMade made("O1.nc", "O1\nG83 X1. Z-9. R2. F9\nM30\n");
    add(made, "G83", "MAC523/G83.Q");
    add(made, "G83", "MAC523/G73.Q");
    made.add("M30", Severity::error);
    return made;
}

TEST(RowsInReports, AreNamedBehindTheirRulesForPeople) {
    HandMade made = drilling();
    EXPECT_THAT(write_text(made.report(), {}),
                AllOf(HasSubstr("warning[MAC523/G83.Q]: Word missing beside G83"),
                      HasSubstr("more: maclint explain MAC523/G83.Q\n"),
                      HasSubstr("more: maclint explain MAC523/G73.Q\n"), HasSubstr("error[MAC002]: ")));
    EXPECT_THAT(write_concise(made.report(), {}),
                AllOf(HasSubstr("O1.nc:2:1: warning[MAC523/G83.Q] Word"), HasSubstr("error[MAC002] ")));
}

TEST(RowsInReports, AreNamedForServices) {
    HandMade made = drilling();
    EXPECT_THAT(write_github(made.report(), {}), HasSubstr(",title=MAC523/G83.Q word-missing::Word missing"));
    const json gitlab = json::parse(write_gitlab(made.report(), {}));
    EXPECT_EQ(gitlab[0]["check_name"], "MAC523/G83.Q");
    EXPECT_EQ(gitlab[2]["check_name"], "MAC002");
    EXPECT_NE(gitlab[0]["fingerprint"], gitlab[1]["fingerprint"]);
}

// Readers cut class names and sources at their last point.
TEST(RowsInReports, KeepTheirPointsOutOfNamesThatAreCutThere) {
    HandMade made = drilling();
    EXPECT_THAT(write_junit(made.report(), {}),
                HasSubstr(R"(classname="maclint.MAC523" name="O1.nc:2:1 word-missing/G83.Q")"));
    EXPECT_THAT(
        write_checkstyle(made.report()),
        AllOf(HasSubstr(R"(Write Q. [MAC523/G83.Q]" source="maclint.modal-state-and-motion-safety.MAC523")"),
              HasSubstr("for the list.\" source=\"maclint.input-and-suppressions.MAC002\"")));
}

TEST(RowsInReports, StandBesideTheCodeInJson) {
    HandMade made = drilling();
    made.report().statistics = true;
    const json report = json::parse(write_json(made.report()));
    EXPECT_EQ(report["findings"][0]["code"], "MAC523");
    EXPECT_EQ(report["findings"][0]["row"], "G83.Q");
    EXPECT_FALSE(report["findings"][2].contains("row"));
    EXPECT_EQ(
        report["statistics"]["rules"],
        json::parse(
            R"([{"code": "MAC002", "name": "unknown-rule-in-suppression", "severity": "error", "findings": 1},
                  {"code": "MAC523", "name": "word-missing", "row": "G73.Q", "severity": "warning", "findings": 1},
                  {"code": "MAC523", "name": "word-missing", "row": "G83.Q", "severity": "warning", "findings": 1}])"));
}

TEST(RowsInReports, AreOneComponentMoreThanTheirDescriptorInSarif) {
    HandMade made = drilling();
    const json run = json::parse(write_sarif(made.report()))["runs"][0];
    const json result = run["results"][0];
    EXPECT_EQ(result["ruleId"], "MAC523/G83.Q");
    EXPECT_EQ(run["tool"]["driver"]["rules"][result["ruleIndex"].get<std::size_t>()]["id"], "MAC523");
    EXPECT_NE(result["partialFingerprints"]["maclint/v2"],
              run["results"][1]["partialFingerprints"]["maclint/v2"]);
}

TEST(RowsInReports, AreCountedOneByOne) {
    HandMade made = drilling();
    add(made, "G83", "MAC523/G83.Q");
    EXPECT_EQ(statistics_text(made.report()), "findings by rule:\n"
                                              "  2  MAC523/G83.Q word-missing (warning)\n"
                                              "  1  MAC002 unknown-rule-in-suppression (error)\n"
                                              "  1  MAC523/G73.Q word-missing (warning)\n"
                                              "findings by file:\n"
                                              "  4  O1.nc\n");
}

TEST(RowsInReports, HaveFingerprintsOfTheirOwn) {
    HandMade made = drilling();
    Fingerprints prints;
    const Finding& with_row = made.report().findings.front().finding;
    Finding without_row = with_row;
    without_row.row = nullptr;
    EXPECT_NE(prints.of_place(with_row, with_row.span), prints.of_place(without_row, with_row.span));
}

TEST(RowsInReports, LeaveTheMessageToFurtherLinesWhereTheirKeysFillTheFirst) {
    const auto all = all_rule_rows();
    const auto longest =
        std::ranges::max_element(all, {}, [](const RuleRow& row) { return row.name().size(); });
    ASSERT_GT(longest->name().size() + std::string_view("warning[]: ").size(), least_width);
    HandMade made("O1.nc", "O1\nG92\nM30\n");
    add(made, "G92", longest->name());
    made.report().findings.front().finding.message_id = longest->rule->messages.front().id;
    const std::string text = write_text(made.report(), {.width = least_width});
    const std::string head = "warning[" + longest->name() + "]: ";
    EXPECT_THAT(text, testing::StartsWith(head));
    EXPECT_THAT(text.substr(head.size(), text.find('\n') - head.size()), Not(HasSubstr(" "))) << text;
    EXPECT_TRUE(is_own_report(text)) << text;
}

TEST(RowsInReports, AreNoReasonToTakeAReportForAProgram) {
    HandMade made = drilling();
    made.report().statistics = true;
    for (const std::string& text :
         {write_text(made.report(), {}), write_text(made.report(), {.width = least_width}),
          write_concise(made.report(), {}), write_github(made.report(), {})}) {
        EXPECT_TRUE(is_own_report(text)) << text;
        std::string other = text; // no such row
        for (std::size_t at = other.find("G83.Q"); at != std::string::npos; at = other.find("G83.Q"))
            other.replace(at, 5, "G83.J");
        EXPECT_FALSE(is_own_report(other)) << other;
    }
}

} // namespace
} // namespace maclint::cli
