//! The rows of the table of words: each is whole, and the examples made from it show it and nothing else.
#include "rules/words/row_examples.hpp"
#include "rules/words/row_place.hpp"
#include "rules/words/word_list.hpp"
#include "tests/support/linted.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint::test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// A row under one of its codes.
struct Case {
    const RuleRow* rule_row;
    const RowForCode* row;
};

/// The rows of one rule and language: there are too many for a test each.
struct Cases {
    std::string name; ///< "MAC523_dinplus"
    std::vector<Case> all;
};

std::vector<Cases> all_cases() {
    std::map<std::string, std::vector<Case>> of_names;
    for (const RuleRow& rule_row : all_rule_rows())
        for (const RowForCode& row : rule_row.rows)
            of_names[std::string(rule_row.rule->code) + "_" + std::string(row.table->language)].push_back(
                {&rule_row, &row});
    std::vector<Cases> cases;
    for (auto& [name, all] : of_names) cases.push_back({name, std::move(all)});
    return cases;
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

class WordRows : public testing::TestWithParam<Cases> {};

TEST_P(WordRows, HaveABadExampleThatRaisesThemAlone) {
    for (const Case& one : GetParam().all) {
        const RowExamples examples = examples_of(*one.row);
        EXPECT_THAT(rows_raised(examples, examples.bad), ElementsAre(one.rule_row->name())) << examples.bad;
    }
}

TEST_P(WordRows, HaveAGoodExampleThatRaisesNoRow) {
    for (const Case& one : GetParam().all) {
        const RowExamples examples = examples_of(*one.row);
        EXPECT_THAT(rows_raised(examples, examples.good), IsEmpty()) << one.rule_row->name() << "\n"
                                                                     << examples.good;
        EXPECT_NE(examples.good, examples.bad) << one.rule_row->name();
    }
}

TEST_P(WordRows, SayWhatComesOfItAndWhereThatIsWritten) {
    for (const Case& one : GetParam().all) {
        SCOPED_TRACE(one.rule_row->name());
        const WordRow& row = *one.row->row;
        ASSERT_FALSE(row.effect.empty());
        EXPECT_TRUE(std::islower(static_cast<unsigned char>(row.effect.view().front())) != 0)
            << row.effect.view();
        EXPECT_NE(row.effect.view().back(), '.') << row.effect.view();
        EXPECT_FALSE(row.source.empty());
        const bool has_words = row.says != RowStatement::alone && row.says != RowStatement::precedes &&
                               row.says != RowStatement::apart && row.says != RowStatement::takes_only &&
                               row.says != RowStatement::refused && row.says != RowStatement::left_on;
        EXPECT_TRUE(!has_words || !row.words.empty());
        EXPECT_TRUE(!has_words || words_of(row.words).size() > 1 || !row.means.empty()) << "what the word is";
        EXPECT_TRUE(row.severity != Severity::error || row.source != "T") << "an error rests on a document";
    }
}

TEST_P(WordRows, NameValuesAndControlsThatThereAre) {
    for (const Case& one : GetParam().all) {
        SCOPED_TRACE(one.rule_row->name());
        const WordRow& row = *one.row->row;
        EXPECT_EQ(row.values.view().find(','), std::string_view::npos) << "blanks separate values";
        const bool has_bounds = std::isfinite(row.least) || std::isfinite(row.most);
        const bool bounds = row.says == RowStatement::values || row.says == RowStatement::digits ||
                            row.says == RowStatement::at_most;
        EXPECT_EQ(bounds, has_bounds || !row.values.empty());
        EXPECT_LE(row.least, row.most);
        for (const std::string_view control : words_of(row.controls))
            EXPECT_NE(find_control(control), nullptr) << "no control is named " << control;
    }
}

INSTANTIATE_TEST_SUITE_P(All, WordRows, testing::ValuesIn(all_cases()),
                         [](const auto& info) { return info.param.name; });

TEST(RuleRows, AreFoundByTheirNames) {
    const RuleRow* row = find_rule_row("MAC523/G83.Q");
    ASSERT_NE(row, nullptr);
    EXPECT_EQ(row->name(), "MAC523/G83.Q");
    EXPECT_EQ(find_rule_row("word-missing/g083.q"), row);
    EXPECT_EQ(find_rule_row("DIN023/G83.Q"), row) << "another code of the rule";
    EXPECT_EQ(find_rule_row("MAC523/G83.E"), nullptr);
    EXPECT_EQ(find_rule_row("MAC523"), nullptr) << "a rule is no row";
}

bool have_common_section(const RowForCode& a, const RowForCode& b) {
    const auto sections = [](const RowForCode& row) {
        return words_of(row.row->sections.empty() ? row.table->sections : row.row->sections);
    };
    const auto of_a = sections(a);
    const auto of_b = sections(b);
    return of_a.empty() || of_b.empty() || std::ranges::find_first_of(of_a, of_b) != of_a.end();
}

/// Both are for it; nullptr: for none.
const ControlModel* common_control(const RowForCode& a, const RowForCode& b) {
    const auto found = std::ranges::find_if(
        controls(), [&](const ControlModel* control) { return is_of(a, *control) && is_of(b, *control); });
    return found == controls().end() ? nullptr : *found;
}

TEST(RuleRows, HaveKeysThatNoOtherRowOfTheirControlHas) {
    for (const RuleRow& rule_row : all_rule_rows())
        for (const RowForCode& a : rule_row.rows)
            for (const RowForCode& b : rule_row.rows) {
                if (&a == &b || !have_common_section(a, b)) continue;
                const ControlModel* common = common_control(a, b);
                EXPECT_EQ(common, nullptr) << rule_row.name() << " on " << (common ? common->name : "");
            }
}

TEST(RuleRows, HaveAliasesThatNoRuleHas) {
    std::set<std::string> known;
    for (const RuleRow& rule_row : all_rule_rows())
        for (const std::string_view alias : words_of(rule_row.first().aliases))
            EXPECT_EQ(find_rule(alias), nullptr) << alias;
}

/// Names and lines of the rows that a program raises: "MAC523/G83.Q 3".
std::vector<std::string> raised_in(std::string_view dialect, const std::string& text,
                                   const std::string& control = {}) {
    cli::Overrides overrides;
    overrides.dialect = find_dialect(dialect);
    if (!control.empty()) overrides.control = control;
    overrides.select = codes_of_row_rules();
    std::vector<std::string> all;
    for (const auto& [finding, suppressed] :
         lint_texts({{"example.nc", text}}, std::move(overrides)).findings)
        all.push_back(finding.row->name() + " " +
                      std::to_string(finding.source->position(finding.span.begin).line));
    return all;
}

TEST(RowsOfBlocks, AreLookedAtInPlainBlocksAndInOthers) {
    EXPECT_THAT(raised_in("fanuc", "O1\nG4 X1. P5\nG4 X#1 P5\nG4 X1.\nM30\n"),
                ElementsAre("MAC575/G4.X-P 2", "MAC575/G4.X-P 3"));
}

TEST(RowsOfBlocks, AreFoundFarInsideARowOfPlainBlocks) {
    std::string text = "O1\n";
    for (int i = 0; i < 5000; ++i) text += "G1 X1. Y2. F100.\n";
    text += "G4 X1. P5\n";
    EXPECT_THAT(raised_in("fanuc", text + "G1 X3.\nM30\n"), ElementsAre("MAC575/G4.X-P 5002"));
}

TEST(RowsOfBlocks, AreFoundInARunWithMoreKindsOfCodesThanItTells) {
    const std::string text =
        "O1\nG0\nG1\nG2\nG3\nG17\nG18\nG19\nG20\nG21\nG54\nG55\nG56\nG57\nG58\nG59\nG61\nG64\nG90\nG91\n"
        "G94\nG95\nG98\nG99\n";
    EXPECT_THAT(raised_in("fanuc", text + "G83 X1. Z-5. R2. F9.\nX3.\nM30\n"),
                ElementsAre("MAC523/G83.Q 25"));
}

TEST(RowsOfBlocks, AreFoundWhereAnotherBlockOfTheRunKeepsThem) {
    EXPECT_THAT(raised_in("fanuc", "O1\nG52 X1.\nG52\nG52 Y1.\nM30\n"),
                ElementsAre("MAC523/G52.X+Y+Z+A+B+C+U+V+W 3"));
    EXPECT_THAT(raised_in("dinplus", "MACHINING\nN1 G48 D1 A50\nN2 G48 A50\nEND\n"),
                ElementsAre("MAC577/G48.A-D 3"));
}

TEST(RowsOfBlocks, AreNotOutOfOrderWhereTheBlockHoldsWhatItsCodeWants) {
    const std::string start = "FINISHED\nN1 G0 X0 Z0\nN2 G1 X40\nN3 G3 X60 Z-10 R10\n";
    const std::string end = "N5 G1 X80\nMACHINING\nEND\n";
    EXPECT_THAT(raised_in("dinplus", start + "N4 G34 F2\n" + end), ElementsAre("MAC580/G3-G22 5"));
    EXPECT_THAT(raised_in("dinplus", start + "N4 G1 Z-30 G34 F2\n" + end), IsEmpty());
}

TEST(RowsOfBlocks, LeaveAWordWithoutItsValueToTheRuleForThat) {
    EXPECT_THAT(raised_in("fanuc", "O1\nG52 X\nM30\n"), IsEmpty());
}

TEST(RowsOfBlocks, AreNoneForNumbersThatAreNoCodes) {
    // As UBSan sees it: none of these may overflow on the way to the code that it is compared with.
    EXPECT_THAT(
        raised_in("fanuc", "O1\nG4 X1. P5 Q99999999999999999999\nX[#1] Y-99999999999999999999.\nM30\n"),
        ElementsAre("MAC575/G4.X-P 2", "MAC107/Q 2", "MAC107/Y 3"));
}

TEST(RowsOfBlocks, HoldOnTheirMachinesAlone) {
    EXPECT_THAT(raised_in("fanuc", "O1\nG0 H5.\nM30\n", "fanuc-16i"), ElementsAre("MAC551/H 2"));
    EXPECT_THAT(raised_in("fanuc", "O1\nG0 H5.\nM30\n", "fanuc-16i-lathe"), IsEmpty());
}

TEST(ValuesOfWords, MayBeTheBoundsWhereThoseAreAllowed) {
    EXPECT_THAT(raised_in("dinplus", "MACHINING\nN1 G4 F0\nN2 G4 F999\nN3 G4 F999.5\nN4 G48 D9 A100\nEND\n"),
                ElementsAre("MAC576/G4.F 2", "MAC576/G4.F 4", "MAC576/G48.A 5"));
}

TEST(RowsOfBlocks, LeaveValuesThatAreCalculatedAlone) {
    EXPECT_THAT(raised_in("fanuc", "O1\nG30 P#1 X0\nG30 P[2+3] X0\nG30 P5 X0\nM30\n"),
                ElementsAre("MAC576/G30.P 4"));
}

TEST(RowsOfBlocks, TakeNoWordThatBelongsToAnotherCode) {
    EXPECT_THAT(raised_in("dinplus", "MACHINING\nN1 G4 F1200\nN2 G1 X50 F1200 G4 D2\nEND\n"),
                ElementsAre("MAC576/G4.F 2"));
    EXPECT_THAT(raised_in("fanuc", "O1\nG90 G30 P5 X0\nG30 G10 L2 P5 X0\nM30\n"),
                ElementsAre("MAC576/G30.P 2"))
        << "G90 takes no words, G10 may";
}

TEST(WordsNotListed, MayBelongToAMoveThatGoesOnBesideAnMFunction) {
    EXPECT_THAT(raised_in("dinplus", "MACHINING\nN1 G1 X50 Z-5\nN2 X60 BR2 M8\nN3 M9 Q2\nEND\n"),
                ElementsAre("MAC581/M9 4"));
}

TEST(RowsOfBlocks, AreSilentWhereTheBlockCallsOrAWordMayBeSkipped) {
    EXPECT_THAT(raised_in("fanuc", "O1\nG65 P9001 G4 X1. P5\nM30\n"), IsEmpty());
    EXPECT_THAT(raised_in("fanuc", "O1\nG#1 G4 X1. P5\nM30\n"), IsEmpty());
    EXPECT_THAT(raised_in("fanuc", "O1\nG65 P9001 G83 Z1.\nM30\n"), IsEmpty()) << "arguments";
    EXPECT_THAT(raised_in("fanuc", "O1\nG30 P5 /X1.\nM30\n"), IsEmpty());
}

TEST(KeptWords, AreNeededInTheFirstBlockOfACycleAlone) {
    EXPECT_THAT(raised_in("fanuc", "O1\nG83 X1. Z-5. R2. Q1. F9.\nG83 X2.\nG80\nG83 X3.\nM30\n"),
                ElementsAre("MAC523/G83.Q 5"));
}

TEST(KeptWords, MayComeFromTheCaller) {
    EXPECT_THAT(raised_in("fanuc", "O1\nG83 X3. Z-5. R2. F9.\nM99\n"), IsEmpty());
    EXPECT_THAT(raised_in("fanuc", "O1\nG80\nG83 X3. Z-5. R2. F9.\nM99\n"), ElementsAre("MAC523/G83.Q 3"));
}

TEST(CodesUnderOthers, AreRefusedWhereOneIsSurelyInForce) {
    EXPECT_THAT(raised_in("fanuc", "O1\nG41 G1 X1. D1\nG31 X5.\nG40 X9.\nG31 X5.\nM30\n"),
                ElementsAre("MAC527/G31-G41 3"));
    EXPECT_THAT(raised_in("fanuc", "O1\nIF[#500EQ1]GOTO5\nG41 G1 X1. D1\nN5 G31 X5.\nM30\n"), IsEmpty())
        << "on some path alone";
    EXPECT_THAT(raised_in("fanuc", "O1\nG41 G1 X1. D1\nG31 X5.\nM30\n", "mitsubishi"), IsEmpty());
}

TEST(RowsOfSections, HoldThereAlone) {
    EXPECT_THAT(raised_in("dinplus", "FINISHED\nN1 G14 Q9\nMACHINING\nN2 G14 Q9\nEND\n"),
                testing::UnorderedElementsAre("MAC527/G14 2", "MAC576/G14.Q 4"));
}

TEST(OrderOfBlocks, LooksForTheNextCode) {
    EXPECT_THAT(
        raised_in("dinplus", "MACHINING\nN1 G41\nN2 M8\nN3 G1 X5\nN4 G40\nN5 G41\nN6 G2 X9 Z1 R9\nEND\n"),
        ElementsAre("MAC580/G41 6"));
    EXPECT_THAT(raised_in("dinplus", "MACHINING\nN1 G41\nN2 X5\nN3 G2 X9 Z1 R9\nEND\n"), IsEmpty())
        << "a move without a code may be straight";
}

/// A run of plain blocks is only read in the lines that hold a code, in letters of either case.
TEST(WordRows, SpeakOfSmallLettersToo) {
    const std::string text = "O9523(HOLES)\nG90G54G0X0Y0\nG83X10.Y10.Z-30.R2.F150.\nG80\nM30\n";
    std::string small = text;
    std::ranges::transform(small, small.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    EXPECT_THAT(codes(lint_text(text)), ElementsAre("MAC523"));
    EXPECT_THAT(codes(lint_text(small)), ElementsAre("MAC523"));
}

} // namespace
} // namespace maclint::test
