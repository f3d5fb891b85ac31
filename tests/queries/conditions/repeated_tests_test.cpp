//! What it takes to find cases that are asked twice.
#include "analyzer/queries/conditions/repeated_tests.hpp"
#include "analyzer/source/budget.hpp"
#include "tests/support/analysed.hpp"

#include <cstddef>
#include <string>

#include <gtest/gtest.h>

namespace maclint::queries {
namespace {

constexpr std::size_t cases = 100;
constexpr std::size_t pairs = cases * (cases - 1) / 2;

/// Cases in a row, each of which asks so many comparisons, all but the last of them the same.
std::string cases_in_a_row(int comparisons) {
    std::string text = "O1\n";
    for (std::size_t i = 1; i <= cases; ++i) {
        text += "IF[[#500EQ0]";
        for (int k = 2; k < comparisons; ++k) text += "OR[#500EQ0]";
        text += "OR[#500EQ" + std::to_string(i) + "]]THEN#1=" + std::to_string(i) + "\n";
    }
    return text + "M30\n";
}

/// Whether they are all held against each other by no more than that work.
bool are_compared_within(std::size_t work, int comparisons) {
    const auto workspace = test::analyse_fanuc(cases_in_a_row(comparisons));
    const Budget budget(work);
    (void)find_repeated_tests(workspace->programs().front());
    return !budget.is_spent();
}

TEST(RepeatedTests, TakeMoreWorkTheMoreComparisonsThereAre) {
    EXPECT_FALSE(are_compared_within(pairs - 1, 2));
    EXPECT_TRUE(are_compared_within(2 * pairs, 2));
    EXPECT_FALSE(are_compared_within(10 * pairs, 100));
    EXPECT_TRUE(are_compared_within(100 * pairs, 100));
}

/// Cases that are the same, of 120 variables each.
TEST(RepeatedTests, AreFoundAmongConditionsOfManyVariables) {
    std::string condition;
    for (int i = 0; i < 120; ++i)
        condition.append(i == 0 ? "" : "OR").append("[#").append(std::to_string(500 + i)).append("EQ1]");
    const std::string asks = "IF[" + condition + "]THEN";
    const auto number_of = [&](const std::string& between) {
        const auto workspace = test::analyse_fanuc("O1\n" + asks + "#1=1\n" + between + asks + "#1=2\nM30\n");
        return find_repeated_tests(workspace->programs().front()).size();
    };
    EXPECT_EQ(number_of(""), 1U);
    EXPECT_EQ(number_of("IF[#700EQ1]THEN#2=1\n"), 1U);
    EXPECT_EQ(number_of("IF[#700EQ1]THEN#619=1\n"), 0U); // which the condition asks
    EXPECT_EQ(number_of("IF[#1EQ1]THEN#2=1\n"), 0U);
}

} // namespace
} // namespace maclint::queries
