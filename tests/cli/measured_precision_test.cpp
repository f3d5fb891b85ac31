//! What was read of a rule's findings: its record and its page say it.
#include "cli/report/measured_precision.hpp"
#include "cli/report/rule_page.hpp"

#include <algorithm>
#include <string>
#include <string_view>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint::cli {
namespace {

using testing::HasSubstr;
using testing::Not;

std::string page_of(std::string_view code) { return markdown_page(*find_rule(code)); }

/// The code of a measured rule of which `is_wanted` is true.
template<typename IsWanted>
std::string_view code_of(IsWanted is_wanted) {
    const auto rules = all_measured_rules();
    const auto found = std::ranges::find_if(rules, is_wanted);
    return found == rules.end() ? std::string_view() : found->code;
}

TEST(MeasuredPrecision, IsThatOfTheRecord) {
    for (const MeasuredRule& entry : all_measured_rules()) {
        const Rule* rule = find_rule(entry.code);
        ASSERT_NE(rule, nullptr) << entry.code;
        if (entry.precision) {
            EXPECT_EQ(rule->precision, *entry.precision) << entry.code;
        }
    }
}

TEST(MeasuredPrecision, CountsNoMoreCorrectFindingsThanDecidedOnes) {
    for (const MeasuredRule& entry : all_measured_rules()) {
        EXPECT_LE(entry.alarms.correct, entry.alarms.decided) << entry.code;
        EXPECT_LE(entry.notes.correct, entry.notes.decided) << entry.code;
    }
}

TEST(MeasuredPrecision, OfARuleThatNobodyReadIsCalledEstimated) {
    EXPECT_EQ(measured("MAC001"), nullptr);
    EXPECT_THAT(page_of("MAC001"), HasSubstr(", estimated."));
}

TEST(MeasuredPrecision, StandsOnThePageWithItsFindings) {
    const MeasuredRule* entry =
        measured(code_of([](const MeasuredRule& rule) { return rule.precision && rule.alarms.decided > 0; }));
    ASSERT_NE(entry, nullptr);
    const std::string findings =
        std::to_string(entry->alarms.correct) + " of " + std::to_string(entry->alarms.decided);
    EXPECT_THAT(page_of(entry->code),
                HasSubstr("measured: " + findings + " findings in real programs were worth acting on."));
    EXPECT_THAT(page_of(entry->code), Not(HasSubstr("estimated")));
}

TEST(MeasuredPrecision, IsToldOfNotesByItself) {
    const MeasuredRule* entry = measured(code_of([](const MeasuredRule& rule) {
        return rule.notes.decided > 0 && find_rule(rule.code)->severity != Severity::note;
    }));
    ASSERT_NE(entry, nullptr);
    EXPECT_THAT(page_of(entry->code),
                HasSubstr("Notes of it worth acting on: " + std::to_string(entry->notes.correct) + " of " +
                          std::to_string(entry->notes.decided) + "."));
}

} // namespace
} // namespace maclint::cli
