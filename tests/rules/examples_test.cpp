//! Every rule's record is complete, and its examples do what the record says.
#include "cli/config/shop_demands.hpp"
#include "tests/support/linted.hpp"

#include <algorithm>
#include <cctype>
#include <set>
#include <sstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint::test {
namespace {

using testing::Contains;
using testing::Each;
using testing::Eq;
using testing::IsEmpty;
using testing::Not;

class RuleExamples : public testing::TestWithParam<const Rule*> {};

std::string name_of(const testing::TestParamInfo<const Rule*>& info) { return std::string(info.param->code); }

cli::Result lint_example(const Rule& rule, const Example& example, const std::vector<std::string>& select) {
    cli::Overrides overrides;
    // The command's own rules look at how a file is recognised: naming its dialect would answer that.
    const bool by_command = std::holds_alternative<RaisedByCommand>(rule.check);
    overrides.dialect = by_command ? nullptr : find_dialect(example.dialect);
    overrides.select = select;
    overrides.complete = example.complete;
    overrides.machine = cli::facts_of_example(example.control);
    return lint_texts({{std::string(example.file), std::string(example.text)}}, std::move(overrides));
}

std::string reported(const cli::Result& result) {
    std::string text;
    for (const auto& [finding, suppressed] : result.findings)
        text += "line " + std::to_string(finding.source->position(finding.span.begin).line) + ": " +
                std::string(finding.rule->code) + " " + finding.message() + "\n";
    return text;
}

/// Numbers of the placeholders in a message's text.
std::set<std::size_t> placeholders(std::string_view text) {
    std::set<std::size_t> numbers;
    for (std::size_t i = 0; i + 2 < text.size(); ++i)
        if (text[i] == '{' && text[i + 2] == '}') numbers.insert(static_cast<std::size_t>(text[i + 1] - '0'));
    return numbers;
}

void expect_filled(const Finding& finding) {
    const auto message = std::ranges::find(finding.rule->messages, finding.message_id, &Message::id);
    ASSERT_NE(message, finding.rule->messages.end()) << "message id " << finding.message_id;
    for (const std::string_view text : {message->text, message->cure})
        for (const std::size_t number : placeholders(text)) {
            ASSERT_LT(number, finding.arguments.size()) << text;
            EXPECT_THAT(finding.arguments[number], Not(IsEmpty())) << text;
        }
}

TEST_P(RuleExamples, BadRaisesExactlyThisRuleWhenItAloneIsSelected) {
    for (const Example& example : GetParam()->bad) {
        const auto result = lint_example(*GetParam(), example, {std::string(GetParam()->code)});
        EXPECT_THAT(codes(result), Not(IsEmpty())) << example.text.substr(0, 400);
        EXPECT_THAT(codes(result), Each(Eq(GetParam()->code))) << reported(result);
    }
}

TEST_P(RuleExamples, BadRaisesNothingElseUnderTheDefaultSelection) {
    const Rule& rule = *GetParam();
    for (const Example& example : rule.bad) {
        const auto result = lint_example(*GetParam(), example, {});
        for (const std::string& code : codes(result))
            EXPECT_TRUE(code == rule.code || lists_code(rule.also, code)) << reported(result);
        if (rule.on_by_default) {
            EXPECT_THAT(codes(result), Contains(rule.code)) << reported(result);
        }
    }
}

TEST_P(RuleExamples, GoodRaisesNothing) {
    for (const Example& example : GetParam()->good) {
        const auto result = lint_example(*GetParam(), example, {});
        EXPECT_THAT(codes(result), IsEmpty()) << reported(result);
        const auto alone = lint_example(*GetParam(), example, {std::string(GetParam()->code)});
        EXPECT_THAT(codes(alone), IsEmpty()) << reported(alone);
    }
}

TEST_P(RuleExamples, FindingsOfDataFlowRulesTellTheWayThatEndsAtThem) {
    if (!GetParam()->data_flow) GTEST_SKIP() << "no data flow in this rule";
    for (const Example& example : GetParam()->bad)
        for (const auto& evaluated :
             lint_example(*GetParam(), example, {std::string(GetParam()->code)}).findings)
            EXPECT_THAT(evaluated.finding.path, Not(IsEmpty())) << example.text.substr(0, 400);
}

TEST_P(RuleExamples, MessagesHaveAllTheirPlaceholdersFilled) {
    for (const Example& example : GetParam()->bad) {
        const auto result = lint_example(*GetParam(), example, {std::string(GetParam()->code)});
        for (const auto& evaluated : result.findings) expect_filled(evaluated.finding);
    }
}

TEST_P(RuleExamples, SpansLieInTheFile) {
    for (const Example& example : GetParam()->bad) {
        const auto result = lint_example(*GetParam(), example, {});
        for (const auto& evaluated : result.findings) {
            const auto inside = [&](const Source& source, Span span) {
                return span.begin <= span.end && span.end <= source.size();
            };
            EXPECT_TRUE(inside(*evaluated.finding.source, evaluated.finding.span));
            for (const RelatedLocation& remark : evaluated.finding.related)
                EXPECT_TRUE(inside(*remark.source, remark.span));
            for (const RelatedLocation& remark : evaluated.finding.path)
                EXPECT_TRUE(inside(*remark.source, remark.span));
        }
    }
}

TEST_P(RuleExamples, RecordIsComplete) {
    const Rule& rule = *GetParam();
    EXPECT_THAT(rule.summary, Not(IsEmpty()));
    EXPECT_FALSE(rule.summary.ends_with('.')) << "a summary is a line, not a sentence: " << rule.summary;
    EXPECT_THAT(rule.why, testing::EndsWith("."));
    EXPECT_THAT(rule.messages, Not(IsEmpty()));
    EXPECT_THAT(rule.bad, Not(IsEmpty()));
    EXPECT_THAT(rule.good, Not(IsEmpty()));
    EXPECT_THAT(rule.sources, Not(IsEmpty()));
    for (const auto* examples : {&rule.bad, &rule.good})
        for (const Example& example : *examples) EXPECT_FALSE(example.text.starts_with('\n')) << example.text;
    const bool precise = rule.precision >= Precision::high;
    if (precise != rule.on_by_default) {
        EXPECT_THAT(rule.off_reason, Not(IsEmpty()));
    }
}

/// What the SARIF Multitool asks of messages (SARIF2001).
TEST_P(RuleExamples, MessagesEndWithAFullStop) {
    for (const Message& message : GetParam()->messages)
        EXPECT_TRUE(message.text.ends_with('.')) << message.text;
}

INSTANTIATE_TEST_SUITE_P(All, RuleExamples, testing::ValuesIn(all_rules().begin(), all_rules().end()),
                         name_of);

bool is_kebab_case(std::string_view name) {
    return !name.empty() && std::ranges::all_of(name, [](unsigned char c) {
        return c == '-' || std::islower(c) != 0 || std::isdigit(c) != 0;
    });
}

TEST(Registry, ListsRulesOnceAndInTheOrderOfTheirCodes) {
    std::vector<std::string> codes;
    std::set<std::string_view> names;
    for (const Rule* rule : all_rules()) {
        codes.emplace_back(rule->code);
        EXPECT_TRUE(names.insert(rule->name).second) << rule->name;
        EXPECT_TRUE(is_kebab_case(rule->name)) << rule->name;
        EXPECT_EQ(find_rule(rule->code), rule);
        EXPECT_EQ(find_rule(rule->name), rule);
    }
    auto sorted = codes;
    const auto family = [](std::string_view code) {
        return std::string_view("MAC DIN SIN").find(code.substr(0, 3));
    };
    std::ranges::sort(
        sorted, {}, [&](const std::string& code) { return std::pair(family(code), std::string_view(code)); });
    EXPECT_EQ(codes, sorted);
    EXPECT_EQ(std::ranges::adjacent_find(sorted), sorted.end());
}

TEST(Registry, RulesSpeakOfOthersByTheirCodes) {
    for (const Rule* rule : all_rules()) {
        std::istringstream codes(std::string(rule->yields_to) + " " + std::string(rule->also));
        for (std::string code; codes >> code;) {
            const Rule* other = find_rule(code);
            ASSERT_NE(other, nullptr) << rule->code << " " << code;
            EXPECT_EQ(other->code, code);
            EXPECT_NE(other, rule);
        }
    }
    EXPECT_TRUE(lists_code("MAC1 MAC22", "mac22"));
    EXPECT_FALSE(lists_code("MAC1 MAC22", "MAC2"));
    EXPECT_FALSE(lists_code("", "MAC2"));
}

} // namespace
} // namespace maclint::test
