//! What the commands show of rows: pages, lists, what holds for a file, and the errors.
#include "cli/commands/show_config.hpp"
#include "rules/words/rule_row.hpp"
#include "tests/support/in_repository.hpp"

#include <sstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace maclint::test {
namespace {

using testing::AllOf;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

class RowPages : public InRepository {};

TEST_F(RowPages, AreShownForAKeyOrAnAlias) {
    const Finished page = run({"explain", "word-missing/g83.q"});
    EXPECT_EQ(page.status, 0);
    EXPECT_THAT(page.out,
                AllOf(StartsWith("MAC523/G83.Q word-missing (modal state and motion safety)\n\nG83 "),
                      HasSubstr("Severity: warning. On by default.\n"),
                      HasSubstr("Where it holds:\n\n    fanuc mills, on fanuc, fanuc-16i or fanuc-0i-c\n"),
                      HasSubstr("FANUC 30i/0i-D: 045 ADDRESS Q NOT FOUND (G73/G83)\n"),
                      HasSubstr("    (MACLINT ALLOW MAC523/G83.Q - REASON)\n"), HasSubstr("\nBad (fanuc):\n"),
                      HasSubstr("\nGood (fanuc):\n"),
                      HasSubstr("\nSource:\n\n    Alarm list of the FANUC 30i"), HasSubstr("(GH-ALM"),
                      HasSubstr("'maclint explain MAC523' says why")));
    EXPECT_THAT(page.out, ContainsRegex("\n  > G83 R")) << "the line that the row finds is marked";
    const Finished alias = run({"explain", "DIN613"});
    EXPECT_THAT(alias.out,
                AllOf(StartsWith("MAC576/G48.A value-not-allowed ("), HasSubstr("Also known as DIN613."),
                      HasSubstr("\n    dinplus, in MACHINING or SUBPROGRAM\n"),
                      HasSubstr("[MACLINT ALLOW MAC576/G48.A - REASON] (dinplus)"),
                      Not(HasSubstr("    (MACLINT"))));
    std::istringstream lines(page.out);
    for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 80U) << line;
}

TEST_F(RowPages, AreListedWhereAWordMayMeanSeveral) {
    const Finished two = run({"explain", "DIN901"});
    EXPECT_EQ(two.status, 0);
    EXPECT_THAT(two.out, AllOf(HasSubstr("    MAC576/G62.H"), HasSubstr("    MAC576/G162.H"),
                               HasSubstr("\n2 rows may be meant by 'DIN901'.\n")));
    EXPECT_THAT(run({"explain", "MAC523/G76"}).out,
                AllOf(HasSubstr("    MAC523/G76.D-NOR"),
                      ContainsRegex("\n[0-9]+ rows may be meant by 'MAC523/G76'[.]\n")));
    const Finished unknown = run({"explain", "MAC523/G82.Q"});
    EXPECT_EQ(unknown.status, 2);
    EXPECT_THAT(unknown.err, HasSubstr("there is no rule 'MAC523/G82.Q'. Did you mean 'MAC523/G"));
}

TEST_F(RowPages, AreListedOnThePageOfTheirRule) {
    const std::string page = run({"explain", "MAC523"}).out;
    for (const RuleRow& row : rows_of(*find_rule("MAC523")))
        EXPECT_THAT(page, HasSubstr("\n    " + row.key + " ("));
    EXPECT_THAT(page, HasSubstr("Its rows, each to be named alone as MAC523/"));
    EXPECT_THAT(page, HasSubstr("G83.Q (warning; fanuc mills"));
    EXPECT_THAT(run({"explain", "MAC301"}).out, Not(HasSubstr("rows")));
    EXPECT_EQ(run({"rules", "--write-docs", "docs"}).status, 0);
    const std::string written = read_file(folder.path() / "docs/MAC523.md");
    EXPECT_THAT(written, HasSubstr("\n## Rows\n\nEach can be named alone, as `MAC523/"));
    EXPECT_THAT(
        written,
        ContainsRegex("\n. G83[.]Q . G83 [^|]+ . fanuc mills[^|]* . warning . on . GH-ALM[^|\n]* .\n"));
    EXPECT_THAT(read_file(folder.path() / "docs/MAC301.md"), Not(HasSubstr("Rows")));
}

TEST_F(RowPages, StandInTheListOfRules) {
    EXPECT_THAT(run({"rules"}).out, ContainsRegex("  MAC523 word-missing [^\n]+\n(         [^\n]+\n)+    /"));
    const auto list = nlohmann::json::parse(run({"rules", "--format", "json"}).out)["rules"];
    for (const auto& rule : list) {
        const auto rows = rows_of(*find_rule(rule["code"].get<std::string>()));
        ASSERT_EQ(rule["rows"].size(), rows.size()) << rule["code"];
        for (std::size_t i = 0; i < rows.size(); ++i) {
            EXPECT_EQ(rule["rows"][i]["key"], rows[i].key);
            EXPECT_EQ(rule["rows"][i]["on_by_default"], rows[i].on_by_default());
            ASSERT_EQ(rule["rows"][i]["entries"].size(), rows[i].rows.size());
            EXPECT_EQ(rule["rows"][i]["entries"][0]["says"], sentence_of(rows[i].rows.front()));
        }
    }
}

TEST_F(RowPages, AreNotRepeatedInEveryReport) {
    folder.write("O1000.nc", without_defect);
    EXPECT_THAT(run({"--format", "sarif"}).out, Not(HasSubstr("Its rows")));
}

/// What --show-config says of rules, behind their number.
class ShownRows : public InRepository {
  protected:
    [[nodiscard]] std::string shown(std::vector<std::string> arguments) const {
        folder.write("O1000.nc", without_defect);
        arguments.emplace_back("--show-config");
        const std::string text = run(arguments).out;
        const std::size_t rules = text.find("\n  rules ");
        return rules == std::string::npos ? text : text.substr(text.find('\n', rules + 1) + 1);
    }
};

TEST_F(ShownRows, AreThoseThatDifferFromTheirRule) {
    EXPECT_EQ(shown({}), "");
    EXPECT_EQ(shown({"--ignore", "MAC523/G83.Q"}), "                 MAC523/G83.Q off (--ignore)\n");
    EXPECT_EQ(shown({"--ignore", "MAC523"}), "                 MAC523 off (--ignore)\n");
    EXPECT_THAT(shown({"--select", "MAC523/G83.Q"}), AllOf(HasSubstr("MAC523 off, MAC523/G83.Q on"),
                                                           HasSubstr("MAC301 off"), Not(HasSubstr("G73.Q"))));
    EXPECT_EQ(shown({"--severity", "MAC523=note", "--severity", "MAC523/G83.Q=error"}),
              "                 MAC523 note, MAC523/G83.Q error (--severity)\n");
}

TEST_F(ShownRows, AreCounted) {
    folder.write("O1000.nc", without_defect);
    const std::string all = std::to_string(all_rule_rows().size());
    EXPECT_THAT(
        run({"--show-config", "--select", "MAC523/G83.Q"}).out,
        HasSubstr("1 of " + std::to_string(all_rules().size()) + " on, 1 of " + all + " rows of rules\n"));
    EXPECT_THAT(run({"--show-config", "--select", "ALL"}).out,
                HasSubstr(" on, " + all + " of " + all + " rows"));
}

TEST_F(RowPages, ABaselineKnowsARowAndNoOtherOfItsRule) {
    folder.write("O1.nc", "O1\nG90 G54 G0 X0 Y0\nG43 Z50. H1\nS2000 M3\nG73 X0 Y10. Z-30. R2. "
                          "F150.\nG80\nG83 X10. Y10. Z-30. R2. F150.\nG80\nM30\n");
    const auto check = [&](std::vector<std::string> arguments) {
        arguments.insert(arguments.begin(), {"--format", "concise", "--quiet"});
        return run(arguments);
    };
    EXPECT_EQ(check({"--select", "MAC523/G83.Q", "--write-baseline", "base.json"}).status, 0);
    EXPECT_THAT(read_file(folder.path() / "base.json"), HasSubstr(R"("rule":"MAC523/G83.Q")"));
    EXPECT_EQ(check({"--select", "MAC523/G83.Q", "--baseline", "base.json"}).out, "");
    EXPECT_THAT(check({"--select", "MAC523", "--baseline", "base.json"}).out,
                AllOf(HasSubstr("[MAC523/G73.Q]"), Not(HasSubstr("G83.Q"))));
    folder.write("O1.nc", "O1\nG90 G54 G0 X0 Y0\nM30\n");
    EXPECT_EQ(run({"--select", "MAC523/G73.Q", "--baseline", "base.json"}).err, "")
        << "it was not looked for";
    EXPECT_THAT(run({"--select", "MAC523/G83.Q", "--baseline", "base.json"}).err,
                HasSubstr("1 entry is gone"));
}

TEST_F(RowPages, AnUnknownKeyIsAnErrorWithTheNearest) {
    EXPECT_THAT(run({"--select", "MAC523/G83.X"}).err,
                HasSubstr("--select names no rule: 'MAC523/G83.X'. Did you mean 'MAC523/G83.Q'"));
    EXPECT_THAT(run({"--severity", "MAC523/G8=note"}).err, HasSubstr("names no rule: 'MAC523/G8'."));
    folder.write(".maclint.json", R"({"ignore": ["MAC523/G83.X"]})");
    folder.write("O1000.nc", without_defect);
    EXPECT_THAT(run({"check"}).err,
                HasSubstr("there is no rule 'MAC523/G83.X'. Did you mean 'MAC523/G83.Q'"));
}

} // namespace
} // namespace maclint::test
