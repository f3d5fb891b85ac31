//! The rows of the table of words: each is whole, and the examples made from it show it and nothing else.
#include "rules/words/row_examples.hpp"
#include "rules/words/word_list.hpp"
#include "tests/support/linted.hpp"

#include <algorithm>
#include <cctype>
#include <set>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint::test {
namespace {

using testing::Contains;
using testing::Each;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

/// A row under one of its codes, and its name for the test.
struct Case {
    const RuleRow* rule_row;
    const RowForCode* row;
};

std::vector<Case> all_cases() {
    std::vector<Case> cases;
    for (const RuleRow& rule_row : all_rule_rows())
        for (const RowForCode& row : rule_row.rows) cases.push_back({&rule_row, &row});
    return cases;
}

std::string name_of(const testing::TestParamInfo<Case>& info) {
    std::string name = info.param.rule_row->name() + "_" + std::to_string(info.index);
    std::ranges::replace_if(
        name, [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
    return name;
}

std::vector<std::string> codes_of_row_rules() {
    std::vector<std::string> codes;
    for (const Rule* rule : all_rules())
        if (std::holds_alternative<RowCheck>(rule->check)) codes.emplace_back(rule->code);
    return codes;
}

/// The names of the rows that the program raises, of all rules that have rows.
std::vector<std::string> rows_raised(const RowExamples& examples, const std::string& text) {
    cli::Overrides overrides;
    overrides.dialect = find_dialect(examples.dialect);
    if (!examples.control.empty()) overrides.control = examples.control;
    overrides.select = codes_of_row_rules();
    std::vector<std::string> names;
    for (const auto& evaluated : lint_texts({{"example.nc", text}}, std::move(overrides)).findings)
        if (evaluated.finding.row != nullptr) names.push_back(evaluated.finding.row->name());
    return names;
}

class WordRows : public testing::TestWithParam<Case> {};

TEST_P(WordRows, TheBadExampleRaisesTheRowAlone) {
    const RowExamples examples = examples_of(*GetParam().row);
    EXPECT_THAT(rows_raised(examples, examples.bad), ElementsAre(GetParam().rule_row->name()))
        << examples.bad;
}

TEST_P(WordRows, TheGoodExampleRaisesNoRow) {
    const RowExamples examples = examples_of(*GetParam().row);
    EXPECT_THAT(rows_raised(examples, examples.good), IsEmpty()) << examples.good;
    EXPECT_NE(examples.good, examples.bad);
}

TEST_P(WordRows, SayWhatComesOfItAndWhereThatIsWritten) {
    const WordRow& row = *GetParam().row->row;
    ASSERT_FALSE(row.effect.empty());
    EXPECT_TRUE(std::islower(static_cast<unsigned char>(row.effect.front())) != 0) << row.effect;
    EXPECT_NE(row.effect.back(), '.') << row.effect;
    EXPECT_FALSE(row.source.empty());
    const bool has_words = row.says != RowStatement::alone && row.says != RowStatement::precedes &&
                           row.says != RowStatement::refused;
    EXPECT_TRUE(!has_words || (!row.words.empty() && !row.means.empty())) << "which words, and what they are";
    EXPECT_TRUE(row.severity != Severity::error || row.source != "T") << "an error rests on a document";
}

INSTANTIATE_TEST_SUITE_P(All, WordRows, testing::ValuesIn(all_cases()), name_of);

TEST(RuleRows, AreFoundByTheirNamesAndAliases) {
    const RuleRow* row = find_rule_row("MAC523/G83.Q");
    ASSERT_NE(row, nullptr);
    EXPECT_EQ(row->name(), "MAC523/G83.Q");
    EXPECT_EQ(find_rule_row("word-missing/g083.q"), row);
    EXPECT_EQ(find_rule_row("DIN023/G83.Q"), row) << "another code of the rule";
    EXPECT_EQ(find_rule_row("MAC523/G83.Z"), nullptr);
    EXPECT_EQ(find_rule_row("MAC523"), nullptr) << "a rule is no row";
    ASSERT_NE(find_rule_row("DIN613"), nullptr);
    EXPECT_EQ(find_rule_row("din613")->name(), "MAC576/G48.A");
}

TEST(RuleRows, HaveKeysThatNoOtherRowOfTheirControlHas) {
    for (const RuleRow& rule_row : all_rule_rows())
        for (const RowForCode& a : rule_row.rows)
            for (const RowForCode& b : rule_row.rows) {
                if (&a == &b || a.table->language != b.table->language) continue;
                const bool same_machine =
                    !a.table->machine || !b.table->machine || a.table->machine == b.table->machine;
                EXPECT_TRUE(!same_machine || (!a.row->controls.empty() && !b.row->controls.empty()))
                    << rule_row.name();
            }
}

TEST(RuleRows, HaveAliasesThatNoRuleHas) {
    std::set<std::string> known;
    for (const RuleRow& rule_row : all_rule_rows())
        for (const std::string_view alias : words_of(rule_row.first().aliases))
            EXPECT_EQ(find_rule(alias), nullptr) << alias;
}

} // namespace
} // namespace maclint::test
