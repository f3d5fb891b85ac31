//! What expressions are known to be, and what conditions turn out to be: each worked out by hand.
#include "analyzer/dataflow/facts/comparison.hpp"
#include "analyzer/dataflow/facts/condition.hpp"
#include "analyzer/dataflow/facts/read.hpp"
#include "tests/support/analysed.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include <gtest/gtest.h>

namespace maclint {
namespace {

using dataflow::Exactness;
using dataflow::Truth;
using dataflow::Vacancy;
using dataflow::Value;
using test::last_read;

enum Outcome : std::uint8_t { always, never, either, unasked };

Outcome outcome_of(Truth truth) {
    if (truth.can_hold && truth.can_fail) return either;
    return truth.can_hold ? always : never;
}

/// How the condition of the last block turns out, in a program that is never called.
Outcome outcome(const std::string& before, const std::string& condition) {
    const auto workspace =
        test::analyse_fanuc("O0001\n" + before + "IF[" + condition + "]GOTO99\nN98M30\nN99M30\n");
    const auto& conditions = workspace->programs().front().facts().all<dataflow::Condition>();
    return conditions.empty() ? unasked : outcome_of(conditions.back().truth);
}

TEST(Evaluate, VariablesOfUnknownIndexesMayDiffer) {
    EXPECT_EQ(outcome("", "#[#500]EQ#[#501]"), either);
    EXPECT_EQ(outcome("", "#[#500]EQ#[#500]"), either);   // two reads, each of its own expression
    EXPECT_EQ(outcome("", "#[99990]EQ#[99991]"), either); // no variables of this control
    EXPECT_EQ(outcome("#1=5000000000\n", "#[#1]EQ#[#1+1]"), either);
    EXPECT_EQ(outcome("#1=5041\n", "#[#1]EQ#[#1+1]"), either); // positions of axes
}

TEST(Evaluate, AKnownIndexIsRoundedAndNamesItsVariable) {
    EXPECT_EQ(outcome("#1=33\n#33=7\n", "#[#1]EQ7"), always);
    EXPECT_EQ(outcome("#1=33\n#33=7\n", "#[#1+0.4]EQ7"), always);
    EXPECT_EQ(outcome("#1=33\n#33=7\n#32=8\n", "#[#1-0.6]EQ8"), always);
    EXPECT_EQ(outcome("#1=0\n", "#[#1]EQ1"), never); // #0 is vacant
    EXPECT_EQ(outcome("#1=4003\nG90\n", "#[#1]EQ90"), always);
    EXPECT_EQ(outcome("#1=4003\nG90\n", "#[#1]EQ91"), never);
}

TEST(Evaluate, AnIndexMadeOfAVacantVariableNamesNothing) {
    EXPECT_EQ(outcome("#10=5\n", "#[#31+10]EQ5"), either);
    EXPECT_EQ(outcome("#10=5\nIF[#500EQ1]GOTO1\n#31=0\nN1", "#[#31+10]EQ5"), either); // it may be
    EXPECT_EQ(outcome("#10=5\n#31=0\n", "#[#31+10]EQ5"), always);
}

TEST(Evaluate, AModalVariableIsTheCodeThatAllWaysHaveSet) {
    EXPECT_EQ(outcome("G90\n", "#4003EQ90"), always);
    EXPECT_EQ(outcome("G91\n", "#4003EQ90"), never);
    EXPECT_EQ(outcome("IF[#500EQ1]GOTO1\nG90\nGOTO2\nN1G90\nN2", "#4003EQ90"), always);
    EXPECT_EQ(outcome("IF[#500EQ1]GOTO1\nG90\nGOTO2\nN1G91\nN2", "#4003EQ90"), either);
    EXPECT_EQ(outcome("IF[#500EQ1]GOTO1\nG90\nGOTO2\nN1G65P77\nN2", "#4003EQ90"), either);
    EXPECT_EQ(outcome("G90\nG65P77\n", "#4003EQ90"), either);
    EXPECT_EQ(outcome("G65P77\n", "#4003EQ#0"), never); // some code is in force
}

TEST(Evaluate, AnInputIsZeroOrOneAndAPositionANumber) {
    EXPECT_EQ(outcome("", "#1000LE1"), always);
    EXPECT_EQ(outcome("", "#1000GE0"), always);
    EXPECT_EQ(outcome("", "#1000EQ1"), either);
    EXPECT_EQ(outcome("", "#1000EQ0"), either);
    EXPECT_EQ(outcome("", "#1000EQ#1000"), either); // it may change between the two
    EXPECT_EQ(outcome("", "#5041LE1"), either);
    EXPECT_EQ(outcome("", "#5041GE0"), either);
    EXPECT_EQ(outcome("#1=#5041\n", "#1EQ#0"), never);
    const Value input = last_read("#1=#1000\nX#1\nM30\n");
    EXPECT_TRUE(input.integer);
    EXPECT_EQ(input.exactness, Exactness::exact);
    // Of few numbers those are left that the test lets through.
    const Value narrowed =
        last_read("IF[#500EQ1]GOTO1\n#1=5\nGOTO3\nN1IF[#500EQ2]GOTO2\n#1=5.5\nGOTO3\nN2#1=7\n"
                  "N3IF[#1EQ7]GOTO9\nX#1\nN9M30\n");
    EXPECT_EQ(narrowed.low, 5);
    EXPECT_EQ(narrowed.high, 5.5);
    const Value tool = last_read("#1=#4120\nX#1\nM30\n");
    EXPECT_TRUE(tool.integer);
    EXPECT_EQ(tool.exactness, Exactness::exact);
    const Value position = last_read("#1=#5041\nX#1\nM30\n");
    EXPECT_FALSE(position.integer);
    EXPECT_EQ(position.exactness, Exactness::unknown);
}

TEST(Evaluate, WhatAProbeOfALatheHasFoundMayBeNothing) {
    const auto vacancy_of = [](const std::string& value) {
        const auto workspace = test::analyse_text("dinplus", "MACHINING\n#l1=" + value + "\nG0 X#l1\nM30\n");
        return workspace->programs().front().facts().all<dataflow::Read>().back().value.vacancy;
    };
    EXPECT_EQ(vacancy_of("#a9(Z,1)"), Vacancy::unknown);
    EXPECT_EQ(vacancy_of("5"), Vacancy::set);
}

TEST(Evaluate, TheNullVariableIsVacantForNoOtherReason) {
    for (const std::string null : {"#1=#0\n", "#2=0\n#1=#[#2]\n"}) {
        const Value value = last_read(null + "X#1\nM30\n");
        EXPECT_EQ(value.vacancy, Vacancy::vacant) << null;
        EXPECT_EQ(value.vacancy_origin, 0U) << null;
    }
}

// ---- conditions ----

TEST(Truths, OfAndAreThoseOfAllItsParts) {
    const std::string set = "#1=1\n#2=2\n";
    EXPECT_EQ(outcome(set, "[#1EQ1]AND[#2EQ2]"), always);
    EXPECT_EQ(outcome(set, "[#1EQ1]AND[#2EQ3]"), never);
    EXPECT_EQ(outcome(set, "[#1EQ2]AND[#2EQ2]"), never);
    EXPECT_EQ(outcome(set, "[#1EQ1]AND[#500EQ1]"), either);
    EXPECT_EQ(outcome(set, "[#1EQ2]AND[#500EQ1]"), never);
    EXPECT_EQ(outcome("", "[#500EQ1]AND[#501EQ1]"), either);
}

TEST(Truths, OfOrAreThoseOfAnyOfItsParts) {
    const std::string set = "#1=1\n#2=2\n";
    EXPECT_EQ(outcome(set, "[#1EQ2]OR[#2EQ3]"), never);
    EXPECT_EQ(outcome(set, "[#1EQ1]OR[#2EQ3]"), always);
    EXPECT_EQ(outcome(set, "[#1EQ2]OR[#2EQ2]"), always);
    EXPECT_EQ(outcome(set, "[#1EQ2]OR[#500EQ1]"), either);
    EXPECT_EQ(outcome(set, "[#1EQ1]OR[#500EQ1]"), always);
    EXPECT_EQ(outcome("", "[#500EQ1]OR[#501EQ1]"), either);
}

TEST(Truths, OfPartsThatExcludeEachOtherOrLeaveNothingOut) {
    EXPECT_EQ(outcome("", "[#500GT5]AND[#500LT3]"), never);
    EXPECT_EQ(outcome("", "[#500GT3]AND[#500LT5]"), either);
    EXPECT_EQ(outcome("", "[#500LT8]OR[#500GT6]"), always);
    EXPECT_EQ(outcome("", "[#500LT6]OR[#500GT8]"), either);
    EXPECT_EQ(outcome("", "[[#500GT5]AND[#501EQ1]]AND[#500LT3]"), never);
    EXPECT_EQ(outcome("", "[#500EQ#0]AND[#500NE#0]"), never);
    EXPECT_EQ(outcome("", "[#500EQ#0]OR[#500NE#0]"), always);
}

TEST(Truths, OfNotAreExchangedAndXorDecidesNothing) {
    EXPECT_EQ(outcome("#1=1\n", "NOT[#1EQ1]"), never);
    EXPECT_EQ(outcome("#1=1\n", "NOT[#1EQ2]"), always);
    EXPECT_EQ(outcome("", "NOT[#500EQ2]"), either);
    EXPECT_EQ(outcome("#1=1\n#2=2\n", "[#1EQ1]XOR[#2EQ2]"), either);
    EXPECT_EQ(outcome("#1=1\n", "#1"), either); // no comparison
}

TEST(Truths, OfVacancyTestsAreThoseOfTheVariable) {
    EXPECT_EQ(outcome("", "#33EQ#0"), always);
    EXPECT_EQ(outcome("", "#33NE#0"), never);
    EXPECT_EQ(outcome("#33=0\n", "#33EQ#0"), never);
    EXPECT_EQ(outcome("#33=0\n", "#33NE#0"), always);
    EXPECT_EQ(outcome("", "#500EQ#0"), either);
}

TEST(Truths, OfOtherThanComparisonsAreReadsOnly) {
    for (const std::string condition : {"#500", "#500AND#501", "[#500EQ1]XOR[#501EQ2]"}) {
        const auto workspace = test::analyse_fanuc("O0001\nIF[" + condition + "]GOTO1\nN1M30\n");
        const auto& facts = workspace->programs().front().facts();
        EXPECT_TRUE(facts.all<dataflow::Comparison>().empty()) << condition;
        ASSERT_FALSE(facts.all<dataflow::Read>().empty()) << condition;
        EXPECT_EQ(facts.all<dataflow::Read>().front().variable.number, 500) << condition;
    }
}

TEST(Truths, AreWrittenDownOnceForEachComparison) {
    const auto workspace = test::analyse_fanuc("O0001\nIF[[#500EQ1]AND[[#501LT#502]OR[#503EQ#0]]]GOTO1\n"
                                               "N1M30\n");
    const auto& facts = workspace->programs().front().facts();
    EXPECT_EQ(facts.all<dataflow::Condition>().size(), 1U);
    ASSERT_EQ(facts.all<dataflow::Comparison>().size(), 3U);
    EXPECT_EQ(facts.all<dataflow::Comparison>()[0].operation, Operation::equal);
    EXPECT_EQ(facts.all<dataflow::Comparison>()[0].right.constant(), 1);
    EXPECT_EQ(facts.all<dataflow::Comparison>()[1].operation, Operation::less);
    EXPECT_EQ(facts.all<dataflow::Comparison>()[2].operation, Operation::is_vacant);
    EXPECT_EQ(facts.all<dataflow::Comparison>()[2].left_expression,
              facts.all<dataflow::Comparison>()[2].right_expression);
    ASSERT_EQ(facts.all<dataflow::Read>().size(), 4U);
    EXPECT_TRUE(std::ranges::all_of(facts.all<dataflow::Read>().begin(),
                                    facts.all<dataflow::Read>().begin() + 3,
                                    [](const auto& read) { return read.use == dataflow::Use::comparison; }));
    EXPECT_EQ(facts.all<dataflow::Read>()[3].use, dataflow::Use::vacancy_test);
}

} // namespace
} // namespace maclint
