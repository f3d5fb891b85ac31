//! What was read of a rule's findings: its record and its page say it.
#include "cli/report/measured_precision.hpp"
#include "cli/report/rule_page.hpp"

#include <optional>
#include <string>
#include <string_view>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint::cli {
namespace {

using testing::HasSubstr;

const Rule& rule_with(std::string_view code) { return *find_rule(code); }

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

TEST(MeasuredPrecision, IsFoundByTheCode) {
    ASSERT_FALSE(all_measured_rules().empty());
    for (const MeasuredRule& entry : all_measured_rules()) EXPECT_EQ(measured(entry.code), &entry);
    EXPECT_EQ(measured("MAC000"), nullptr);
}

TEST(MeasuredPrecision, OfARuleThatNobodyReadIsCalledEstimated) {
    const Rule& rule = rule_with("MAC301");
    EXPECT_EQ(precision_of(rule, nullptr),
              "Precision: " + std::string(name_of(rule.precision)) + ", estimated.");
}

TEST(MeasuredPrecision, IsToldWithTheErrorsAndWarningsItRestsOn) {
    const Rule& rule = rule_with("MAC301");
    const MeasuredRule entry{"MAC301", Precision::high, {10, 11}, {}};
    EXPECT_EQ(precision_of(rule, &entry),
              "Precision: " + std::string(name_of(rule.precision)) +
                  ", measured: 10 of 11 findings in real programs were worth acting on.");
}

TEST(MeasuredPrecision, OfARuleThatIsANoteRestsOnItsNotes) {
    const MeasuredRule entry{"MAC604", Precision::medium, {}, {3, 5}};
    EXPECT_THAT(precision_of(rule_with("MAC604"), &entry),
                testing::EndsWith(", measured: 3 of 5 findings in real programs were worth acting on."));
}

TEST(MeasuredPrecision, DoesNotHideTheNotesOfOtherRules) {
    const MeasuredRule entry{"MAC301", std::nullopt, {}, {1, 16}};
    EXPECT_THAT(precision_of(rule_with("MAC301"), &entry),
                testing::EndsWith(", estimated. Notes of it worth acting on: 1 of 16."));
}

TEST(MeasuredPrecision, StandsOnThePage) {
    for (const MeasuredRule& entry : all_measured_rules()) {
        const Rule& rule = rule_with(entry.code);
        EXPECT_THAT(markdown_page(rule), HasSubstr(precision_of(rule, &entry) + " ")) << entry.code;
    }
    EXPECT_THAT(
        markdown_page(rule_with("MAC001")),
        HasSubstr(", estimated. Very high: of 20 findings at least 19 are worth acting on. On by default."));
}

} // namespace
} // namespace maclint::cli
