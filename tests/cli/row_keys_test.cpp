//! Keys of rows, wherever rules are named: MAC523/G83.Q is one row of MAC523 alone.
#include "cli/config/rule_words.hpp"
#include "cli/config/settings.hpp"
#include "tests/support/folder.hpp"
#include "tests/support/linted.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint::cli {
namespace {

using test::lint_texts;
using test::TemporaryFolder;
using testing::Each;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::UnorderedElementsAre;

/// "MAC523", "MAC523/G83.Q".
std::string text_of(const NamedRule& named) {
    return named.row == nullptr ? std::string(named.rule->code) : named.row->name();
}

std::vector<std::string> texts_of(const std::vector<NamedRule>& named) {
    std::vector<std::string> texts;
    for (const NamedRule& one : named) texts.push_back(text_of(one));
    return texts;
}

std::vector<std::string> named_by(std::string_view word) { return texts_of(rules_named(word)); }

TEST(RuleWords, OfARuleAreAllOfItAndWithAKeyOneRow) {
    EXPECT_THAT(named_by("MAC523"), ElementsAre("MAC523"));
    EXPECT_THAT(named_by("MAC523/G83.Q"), ElementsAre("MAC523/G83.Q"));
    EXPECT_THAT(named_by("word-missing/g083.q"), ElementsAre("MAC523/G83.Q"));
    EXPECT_THAT(named_by("MAC5"), testing::Contains("MAC523"));
    EXPECT_THAT(named_by("MAC5"), testing::Not(testing::Contains("MAC523/G83.Q")));
}

TEST(RuleWords, OfAnAliasAreTheRowsThatHaveIt) {
    EXPECT_THAT(named_by("DIN613"), ElementsAre("MAC576/G48.A"));
    EXPECT_THAT(named_by("din613"), ElementsAre("MAC576/G48.A"));
    EXPECT_THAT(named_by("DIN901"), UnorderedElementsAre("MAC576/G62.H", "MAC576/G162.H"));
}

TEST(RuleWords, NameNothingWithAKeyThatNoRowHas) {
    for (const std::string_view word :
         {"MAC523/", "MAC523/G83", "MAC523/G83.QQ", "MAC301/G83.Q", "MAC999/G83.Q", "MAC5/G83.Q", "ALL/G83.Q",
          "/G83.Q", "MAC523/G83.Q/", "G83.Q", "MAC523 G83.Q"})
        EXPECT_THAT(named_by(word), IsEmpty()) << word;
}

TEST(RuleWords, MayMeanTheRowsOfACodeOrKey) {
    EXPECT_THAT(texts_of(rules_meant("MAC523/g402")), UnorderedElementsAre("MAC523/G402.K", "MAC523/G402.Q"));
    EXPECT_THAT(texts_of(rules_meant("MAC576/g83.q")), ElementsAre("MAC576/G83.Q"));
    EXPECT_THAT(texts_of(rules_meant("G48")),
                testing::IsSupersetOf(
                    {"MAC527/G48", "MAC576/G48.A", "MAC576/G48.D", "MAC577/G48.A-D", "MAC581/G48"}));
    for (const std::string code : {"G48", "G4"})
        EXPECT_THAT(texts_of(rules_meant(code)),
                    Each(testing::MatchesRegex("MAC[0-9]+/" + code + "([.-].*)?")));
    EXPECT_THAT(rules_meant("MAC523/"), IsEmpty());
}

TEST(RuleWords, OfAMistypedKeyAreTheNearestOnes) {
    EXPECT_EQ(advice_for("MAC523/G402"), " Did you mean 'MAC523/G402.K' or 'MAC523/G402.Q'?");
    EXPECT_EQ(advice_for("MAC523/G402.O"), " Did you mean 'MAC523/G402.K' or 'MAC523/G402.Q'?");
    EXPECT_EQ(advice_for("word-mising/G83.Q"), " Did you mean 'word-missing/G83.Q'?");
    EXPECT_EQ(advice_for("MAC551/G402.Q"), " Did you mean 'MAC523/G402.Q'?") << "of another rule";
    EXPECT_EQ(advice_for("MAC576/G48"), " Did you mean 'MAC576/G48.A' or 'MAC576/G48.D'?");
    EXPECT_EQ(advice_for("MAC301/G83.Z"), " Did you mean 'MAC301'?") << "a rule without rows";
    EXPECT_EQ(advice_for("MAC523/QQ"), " See 'maclint explain MAC523' for its rows.");
    EXPECT_EQ(advice_for("HOUSE/RULE"), " See 'maclint rules' for the list.");
}

/// Which of the rows that these tests speak of are on.
std::vector<std::string> rows_on(const RuleStates& states) {
    std::vector<std::string> on;
    for (const std::string name : {"MAC523/G83.Q", "MAC523/G73.Q", "MAC576/G48.A"})
        if (states.of(*find_rule_row(name)).on) on.push_back(name);
    return on;
}

RuleStates only(std::string_view word) {
    RuleStates states;
    states.select_only(rules_named(word), "");
    return states;
}

TEST(RuleStates, OfRowsAreAsTheyCome) {
    const RuleStates states;
    for (const RuleRow& row : all_rule_rows()) {
        EXPECT_EQ(states.of(row).on, row.on_by_default()) << row.name();
        EXPECT_EQ(states.reason_of(states.of(row)), row.on_by_default() ? "on by default" : "off by default");
    }
}

TEST(RuleStates, WhatIsSaidOfARuleIsSaidOfAllItsRows) {
    for (const std::string_view word : {"MAC523", "MAC5", "ALL", "word-missing"})
        for (const RuleRow& row : rows_of(*find_rule("MAC523")))
            EXPECT_TRUE(only(word).of(row).on) << row.name();
    EXPECT_THAT(rows_on(only("MAC523")), ElementsAre("MAC523/G83.Q", "MAC523/G73.Q"));
    RuleStates states;
    states.set_severity(rules_named("MAC523"), Severity::note, "--severity");
    EXPECT_EQ(states.of(*find_rule_row("MAC523/G83.Q")).severity, Severity::note);
    EXPECT_EQ(states.of(*find_rule_row("MAC576/G48.A")).severity, std::nullopt);
}

TEST(RuleStates, ARuleFindsSomethingWhenOneOfItsRowsIsOn) {
    const Rule& rule = *find_rule("MAC523");
    RuleStates states = only("MAC523/G83.Q");
    EXPECT_THAT(rows_on(states), ElementsAre("MAC523/G83.Q"));
    EXPECT_TRUE(states.is_on(rule));
    EXPECT_FALSE(states.of(rule).on) << "nobody asked for all of it";
    EXPECT_FALSE(states.is_on(*find_rule("MAC576")));
    EXPECT_FALSE(states.is_on(*find_rule("MAC301")));
    states.switch_off(rules_named("MAC523/G83.Q"), "");
    EXPECT_FALSE(states.is_on(rule));
    for (const RuleRow& row : rows_of(rule)) {
        states = only("MAC523");
        for (const RuleRow& other : rows_of(rule))
            if (&other != &row) states.switch_off({{&rule, &other}}, "");
        EXPECT_TRUE(states.is_on(rule)) << row.name();
    }
}

TEST(RuleStates, WhatIsSaidLaterCounts) {
    RuleStates states = only("MAC523");
    states.switch_off(rules_named("MAC523/G83.Q"), "");
    EXPECT_THAT(rows_on(states), ElementsAre("MAC523/G73.Q"));
    states = only("MAC523/G83.Q");
    states.switch_off(rules_named("MAC523"), "");
    EXPECT_THAT(rows_on(states), IsEmpty());
    states.set_severity(rules_named("MAC523/G83.Q"), Severity::error, "");
    states.set_severity(rules_named("MAC523"), Severity::note, "");
    EXPECT_EQ(states.of(*find_rule_row("MAC523/G83.Q")).severity, Severity::note);
}

/// Settings of a file under a configuration that says this.
FileSettings settings_under(std::string_view text, Overrides overrides = {}) {
    const TemporaryFolder folder;
    folder.write(".maclint.json", text);
    Settings settings(std::move(overrides));
    return settings.for_file((folder.path() / "O1.nc").string()).value();
}

std::vector<std::string> rows_on(const FileSettings& settings) { return rows_on(*settings.rules); }

TEST(Configuration, NamesRowsWhereverItNamesRules) {
    EXPECT_THAT(rows_on(settings_under(R"({"select": ["MAC523/G83.Q", "DIN613"]})")),
                ElementsAre("MAC523/G83.Q", "MAC576/G48.A"));
    EXPECT_THAT(rows_on(settings_under(R"({"ignore": ["word-missing/g83.q"]})")),
                ElementsAre("MAC523/G73.Q", "MAC576/G48.A"));
    EXPECT_THAT(
        rows_on(settings_under(R"({"per-file-ignores": {"O1*": ["MAC523/G83.Q"], "O2*": ["MAC576"]}})")),
        ElementsAre("MAC523/G73.Q", "MAC576/G48.A"));
    EXPECT_THAT(rows_on(settings_under(R"({"select": ["MAC523/G83.Q"], "ignore": ["MAC523"]})")), IsEmpty());
}

TEST(Configuration, GivesARowTheLastWordOnItsSeverity) {
    const auto severity = [](std::string_view text) {
        return settings_under(text).rules->of(*find_rule_row("MAC523/G83.Q")).severity;
    };
    EXPECT_EQ(severity(R"({"severity": {"MAC523/G83.Q": "error", "MAC523": "note", "MAC5": "note"}})"),
              Severity::error);
    EXPECT_EQ(severity(R"({"severity": {"MAC523": "note", "MAC5": "error"}})"), Severity::note);
}

TEST(Settings, LayRowsOfTheCommandLineOverTheConfiguration) {
    Overrides overrides;
    overrides.select = {"MAC523"};
    overrides.ignore = {"MAC523/G73.Q"};
    overrides.severity = {{"MAC523/G83.Q", Severity::error}};
    const FileSettings settings = settings_under(R"({"ignore": ["MAC523/G83.Q"]})", overrides);
    EXPECT_THAT(rows_on(settings), ElementsAre("MAC523/G83.Q"));
    EXPECT_EQ(settings.rules->of(*find_rule_row("MAC523/G83.Q")).severity, Severity::error);
}

// ---- findings

/// Lacks Q beside G73 and beside G83: `beside_73` and `beside_83` stand at the ends of these blocks.
std::string drilling(std::string_view top, std::string_view beside_73, std::string_view beside_83) {
    return "O1(PECK)\n" + std::string(top) +
           "G90 G54 G0 X0 Y0\nG43 Z50. H1\nS2000 M3\nG73 X0 Y10. Z-30. R2. F150. " + std::string(beside_73) +
           "\nG80\nG83 X10. Y10. Z-30. R2. F150. " + std::string(beside_83) + "\nG80\nM30\n";
}

/// Findings that nothing allows, with their severities where these are no warnings.
std::vector<std::string> found_in(const std::vector<test::LintedText>& texts, const Overrides& overrides) {
    std::vector<std::string> found;
    for (const auto& [finding, suppressed] : lint_texts(texts, overrides).findings)
        if (!suppressed)
            found.push_back(code_with_key(finding) +
                            (finding.severity == Severity::warning ? "" : " no warning"));
    return found;
}

std::vector<std::string> found(std::string_view top, std::string_view beside_73, std::string_view beside_83,
                               const std::vector<std::string>& select = {}) {
    Overrides overrides;
    overrides.select = select;
    return found_in({{"O1.nc", drilling(top, beside_73, beside_83)}}, overrides);
}

TEST(Rows, AreFoundAsTheyAreSelected) {
    EXPECT_THAT(found("", "", ""), ElementsAre("MAC523/G73.Q", "MAC523/G83.Q"));
    EXPECT_THAT(found("", "", "", {"MAC523/G83.Q"}), ElementsAre("MAC523/G83.Q"));
    EXPECT_THAT(found("", "", "", {"MAC523/G83.Q", "MAC523"}), ElementsAre("MAC523/G73.Q", "MAC523/G83.Q"));
    EXPECT_THAT(found("", "", "", {"DIN613", "MAC301"}), IsEmpty());
    Overrides overrides;
    overrides.ignore = {"MAC523/G73.Q"};
    overrides.severity = {{"MAC523/G83.Q", Severity::error}};
    EXPECT_THAT(found_in({{"O1.nc", drilling("", "", "")}}, overrides),
                ElementsAre("MAC523/G83.Q no warning"));
}

TEST(Rows, AreAllowedByTheirKeysOrByTheirRule) {
    EXPECT_THAT(found("", "", "(MACLINT ALLOW MAC523/G83.Q - ONE STROKE)"), ElementsAre("MAC523/G73.Q"));
    EXPECT_THAT(found("", "", "(MACLINT ALLOW word-missing/G083.q)"), ElementsAre("MAC523/G73.Q"));
    EXPECT_THAT(found("", "", "(MACLINT ALLOW MAC523)"), ElementsAre("MAC523/G73.Q"));
    EXPECT_THAT(found("", "", "(MACLINT ALLOW MAC523/G73.Q)"),
                ElementsAre("MAC523/G73.Q", "MAC523/G83.Q", "MAC001"));
    EXPECT_THAT(found("(MACLINT ALLOW-FILE MAC523/G73.Q)\n", "", ""), ElementsAre("MAC523/G83.Q"));
    EXPECT_THAT(found("(MACLINT ALLOW-FILE MAC523)\n", "", ""), IsEmpty());
}

TEST(Rows, AreSwitchedOffAndOnAloneOrWithTheirRule) {
    EXPECT_THAT(found("(MACLINT OFF MAC523/G83.Q)\n", "", ""), ElementsAre("MAC523/G73.Q"));
    EXPECT_THAT(found("(MACLINT OFF MAC523)\n", "(MACLINT ON MAC523/G83.Q)", ""),
                ElementsAre("MAC523/G83.Q"));
    EXPECT_THAT(found("(MACLINT OFF MAC523)\n(MACLINT ON MAC523/G83.Q)\n(MACLINT OFF MAC523)\n", "", ""),
                ElementsAre("MAC001"));
    EXPECT_THAT(found("(MACLINT OFF MAC523/G83.Q)\n", "(MACLINT ON MAC523)", ""),
                ElementsAre("MAC001", "MAC523/G73.Q", "MAC523/G83.Q"));
    EXPECT_THAT(found("(MACLINT OFF MAC523/G83.Q MAC523/G73.Q)\n", "(MACLINT ON)", ""),
                ElementsAre("MAC001", "MAC523/G83.Q"));
}

TEST(Rows, AreAllowedByTheLastThatSpeaksForTheBlockAndTheFirstForTheFile) {
    const auto needless = [](const std::string& text) {
        std::vector<std::string> words;
        for (const auto& [finding, suppressed] : lint_texts({{"O1.nc", text}}, {}).findings)
            if (finding.rule->code == "MAC001") words.push_back(finding.arguments.front());
        return words;
    };
    EXPECT_THAT(needless(drilling("", "(MACLINT ALLOW MAC523)", "(MACLINT ALLOW MAC523 MAC523/G83.Q)")),
                ElementsAre("MAC523"));
    EXPECT_THAT(needless(drilling("", "(MACLINT ALLOW MAC523)", "(MACLINT ALLOW MAC523/G83.Q MAC523)")),
                ElementsAre("MAC523/G83.Q"));
    EXPECT_THAT(needless(drilling("(MACLINT ALLOW-FILE MAC523/G83.Q MAC523)\n", "", "")), IsEmpty());
    EXPECT_THAT(needless(drilling("(MACLINT ALLOW-FILE MAC523 MAC523/G83.Q)\n", "", "")),
                ElementsAre("MAC523/G83.Q"));
}

TEST(Rows, OfACommentAreLookedForWhetherSelectedOrNot) {
    const std::vector<std::string> others = {"MAC001", "MAC523/G73.Q"};
    EXPECT_THAT(found("", "", "(MACLINT ALLOW MAC523/G83.Q - WANTED)", others), ElementsAre("MAC523/G73.Q"));
    EXPECT_THAT(found("", "", "(MACLINT ALLOW MAC523 - WANTED)", others), ElementsAre("MAC523/G73.Q"));
    EXPECT_THAT(found("", "", "(MACLINT ALLOW MAC523/G76.Q+I+J - NOT THERE)", others),
                ElementsAre("MAC523/G73.Q", "MAC001"));
    EXPECT_THAT(found("", "", "(MACLINT ALLOW MAC523/G83.Q - WANTED)", {"MAC001"}), IsEmpty());
}

TEST(Rows, ThatOneFileWantsAreNotFoundInOthers) {
    const TemporaryFolder folder;
    folder.write(".maclint.json", R"({"select": ["MAC523"], "per-file-ignores": {"O1*": ["MAC523/G83.Q"]}})");
    Settings settings({});
    Snapshot snapshot;
    for (const std::string name : {"O1.nc", "O2.nc"}) {
        const std::string path = (folder.path() / name).string();
        snapshot.files.push_back({{.path = path},
                                  settings.for_file(path).value(),
                                  Source::from_bytes(path, drilling("", "", ""))});
    }
    Progress progress(Progress::Shown::never);
    std::vector<std::string> found;
    for (const auto& [finding, suppressed] : Engine({}, progress).analyse(snapshot).findings)
        found.push_back(finding.source->path().substr(folder.path().string().size() + 1) + " " +
                        code_with_key(finding));
    EXPECT_THAT(found, ElementsAre("O1.nc MAC523/G73.Q", "O2.nc MAC523/G73.Q", "O2.nc MAC523/G83.Q"));
}

TEST(Rows, ThatDoNotExistAreToldWithTheLikelyOne) {
    Overrides overrides;
    overrides.select = {"MAC002"};
    const auto result = lint_texts(
        {{"O1.nc", drilling("", "(MACLINT ALLOW MAC523/G73.X - T)", "(MACLINT ALLOW MAC301/R1 - T)")}},
        overrides);
    ASSERT_EQ(result.findings.size(), 2U);
    EXPECT_THAT(result.findings[0].finding.message(), HasSubstr("no 'MAC523/G73.X'. Write 'MAC523/G73."));
    EXPECT_THAT(result.findings[1].finding.message(), HasSubstr("Write 'MAC301'"));
    EXPECT_EQ(result.findings[0].finding.source->bytes(result.findings[0].finding.span), "MAC523/G73.X");
}

} // namespace
} // namespace maclint::cli
