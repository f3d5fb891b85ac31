//! What a program knows after a condition: each bound worked out by hand.
#include "analyzer/dataflow/facts/comparison.hpp"
#include "analyzer/dataflow/facts/read.hpp"
#include "tests/dataflow/expect.hpp"
#include "tests/support/analysed.hpp"

#include <cmath>
#include <string>

#include <gtest/gtest.h>

namespace maclint {
namespace {

using dataflow::Exactness;
using dataflow::Vacancy;
using dataflow::Value;
using test::last_read;

using dataflow::infinity;

/// What #500, of which nothing is known, is where the condition holds.
Value where(const std::string& condition) {
    return last_read("IF[" + condition + "]GOTO1\nM30\nN1X#500\nM30\n");
}
/// What #1 is there: a whole number from 0 to 10 (an input is 0 or 1).
Value whole_where(const std::string& condition) {
    return last_read("#1=#1000*10\nIF[" + condition + "]GOTO1\nM30\nN1X#1\nM30\n");
}

const double just_above_5 = std::nextafter(5.0, 6.0), just_below_5 = std::nextafter(5.0, 4.0);

TEST(Refine, BothSidesOfAComparisonAreCut) {
    EXPECT_RANGE(where("#500LT5"), -infinity, just_below_5);
    EXPECT_RANGE(where("#500LE5"), -infinity, 5);
    EXPECT_RANGE(where("#500EQ5"), 5, 5);
    EXPECT_RANGE(where("#500NE5"), -infinity, infinity);
    EXPECT_RANGE(where("#500GE5"), 5, infinity);
    EXPECT_RANGE(where("#500GT5"), just_above_5, infinity);
    EXPECT_RANGE(where("5GT#500"), -infinity, just_below_5);
    EXPECT_RANGE(where("5GE#500"), -infinity, 5);
    EXPECT_RANGE(where("5EQ#500"), 5, 5);
    EXPECT_RANGE(where("5LE#500"), 5, infinity);
    EXPECT_RANGE(where("5LT#500"), just_above_5, infinity);
}

TEST(Refine, OneOfTheNumbersThatAConditionNamesIsLeft) {
    for (const std::string either :
         {"[#500EQ3]OR[#500EQ5]", "NOT[[#500NE5]AND[#500NE3]]", "[#500EQ3]OR[[#500EQ5]OR[#500EQ3]]"}) {
        EXPECT_RANGE(where(either), 3, 5);
        EXPECT_EQ(where(either).vacancy, Vacancy::set) << either;
        EXPECT_NE(where(either).choices, 0U) << either;
    }
    const std::string rest = "IF[[#500NE3]AND[#500NE5]]GOTO9\nIF[#500EQ3]GOTO9\n";
    EXPECT_EQ(last_read(rest + "X#500\nN9M30\n").constant(), 5);
    for (const std::string other :
         {"[#500EQ3]OR[#501EQ5]", "[#500EQ3]OR[#500GT5]", "[#500EQ3]OR[#500EQ#501]"})
        EXPECT_RANGE(where(other), -infinity, infinity);
}

TEST(Refine, NoFactorOfWhatIsNotZeroIsZeroOrVacant) {
    for (const std::string product : {"#500*#501NE0", "#501*[2*#500]GT0", "#500*#500LT0"}) {
        EXPECT_EQ(where(product).vacancy, Vacancy::set) << product;
        EXPECT_TRUE(where(product).nonzero) << product;
    }
    for (const std::string other : {"#500*#501GE0", "#500*#501NE1", "#500+#501NE0", "#500*#501NE#502"}) {
        EXPECT_EQ(where(other).vacancy, Vacancy::unknown) << other;
        EXPECT_FALSE(where(other).nonzero) << other;
    }
}

TEST(Refine, WhereAComparisonFailsItsOppositeHolds) {
    EXPECT_RANGE(where("NOT[#500LT5]"), 5, infinity);
    EXPECT_RANGE(where("NOT[#500NE5]"), 5, 5);
    EXPECT_RANGE(where("NOT[#500GT5]"), -infinity, 5);
    EXPECT_RANGE(last_read("IF[#500GE5]GOTO1\nX#500\nN1M30\n"), -infinity, just_below_5);
    EXPECT_RANGE(last_read("IF[#500NE5]GOTO1\nX#500\nN1M30\n"), 5, 5);
}

TEST(Refine, AWholeNumberIsCutAtWholeNumbers) {
    EXPECT_RANGE(whole_where("#1GT3"), 4, 10);
    EXPECT_RANGE(whole_where("#1GT3.5"), 4, 10);
    EXPECT_RANGE(whole_where("#1LT7"), 0, 6);
    EXPECT_RANGE(whole_where("#1LT6.5"), 0, 6);
    EXPECT_RANGE(whole_where("#1GE3"), 3, 10);
    EXPECT_RANGE(whole_where("#1LE7"), 0, 7);
    EXPECT_RANGE(whole_where("#1NE0"), 1, 10);
    EXPECT_RANGE(whole_where("#1NE10"), 0, 9);
    EXPECT_RANGE(whole_where("#1NE5"), 0, 10);
    EXPECT_RANGE(whole_where("#1LT99"), 0, 10);
    EXPECT_RANGE(whole_where("#1GT-9"), 0, 10);
    EXPECT_RANGE(whole_where("#1LE99"), 0, 10);
    EXPECT_RANGE(whole_where("#1GE-9"), 0, 10);
}

TEST(Refine, AnotherVariableTellsAsMuchAsIsKnownOfIt) {
    EXPECT_RANGE(whole_where("#1LT#500"), 0, 10);
    EXPECT_RANGE(last_read("#1=#1000*10\n#2=#1001+3\nIF[#1LT#2]GOTO1\nM30\nN1X#1\nM30\n"), 0, 3);
    EXPECT_RANGE(last_read("#1=#1000*10\n#2=#1001+3\nIF[#1GT#2]GOTO1\nM30\nN1X#1\nM30\n"), 4, 10);
    EXPECT_RANGE(last_read("#1=#1000*10\n#2=#1001+3\nIF[#1EQ#2]GOTO1\nM30\nN1X#1\nM30\n"), 3, 4);
    EXPECT_RANGE(last_read("#1=#1000*10\n#2=#1001+3\nIF[#1NE#2]GOTO1\nM30\nN1X#1\nM30\n"), 0, 10);
    EXPECT_RANGE(last_read("#1=#1000*10\n#2=#1001+3\nIF[#1LT#2]GOTO1\nM30\nN1X#2\nM30\n"), 3, 4);
    EXPECT_RANGE(last_read("#1=#1000*10\n#2=#1001*20\nIF[#2LT#1]GOTO1\nM30\nN1X#2\nM30\n"), 0, 9);
}

TEST(Refine, WhatDiffersFromARangeMayStillBeAnyOfItsNumbers) {
    for (const std::string other : {"#1001*4", "#1001*4-4", "#1001*4+6", "#1001*4+10"}) {
        const Value value = last_read("#1=#1000*10\n#2=" + other + "\nIF[#1EQ#2]GOTO9\nX#1\nN9M30\n");
        EXPECT_RANGE(value, 0, 10);
        EXPECT_TRUE(value.can_be(0)) << other;
    }
}

TEST(Refine, MinusAVariableTellsOfTheVariable) {
    EXPECT_RANGE(whole_where("-#1LT-3"), 4, 10);
    EXPECT_RANGE(whole_where("-#1GE-3"), 0, 3);
    EXPECT_RANGE(whole_where("-#1NE0"), 1, 10);
    EXPECT_RANGE(whole_where("-#1NE-10"), 0, 9);
    EXPECT_RANGE(whole_where("-#1NE#30"), 0, 10); // #30 is vacant, and no number is
    EXPECT_RANGE(where("-#500GT5"), -infinity, -just_above_5);
    EXPECT_RANGE(where("-#500LE5"), -5, infinity);
    EXPECT_RANGE(where("5LT-#500"), -infinity, -just_above_5);
    EXPECT_RANGE(where("-#500EQ5"), -infinity, infinity);
    EXPECT_RANGE(where("-[#500+1]GT5"), -infinity, infinity);
}

TEST(Refine, OfLinkedConditionsAllThatMustBeTrueIsKnown) {
    EXPECT_RANGE(where("[#500GE3]AND[#500LE7]"), 3, 7);
    EXPECT_RANGE(where("NOT[[#500LT3]OR[#500GT7]]"), 3, 7);
    EXPECT_RANGE(where("[#500GE3]OR[#500LE7]"), -infinity, infinity);
    EXPECT_RANGE(where("NOT[[#500LT3]AND[#500GT7]]"), -infinity, infinity);
    EXPECT_RANGE(where("[[#500GE3]AND[#501EQ1]]AND[#500LE7]"), 3, 7);
    EXPECT_RANGE(where("[[#500GE3]OR[#501EQ1]]AND[#500LE7]"), -infinity, 7);
    EXPECT_RANGE(where("[#500GE3]XOR[#500LE7]"), -infinity, infinity);
}

TEST(Refine, WhatIsEqualToANumberIsThatNumber) {
    const Value five = where("#500EQ5");
    EXPECT_EQ(five.constant(), 5);
    EXPECT_EQ(five.exactness, Exactness::exact);
    EXPECT_TRUE(five.integer);
    const auto workspace =
        test::analyse_fanuc("O0001\nX#500\nIF[#500NE5]GOTO9\nX#500\nIF[#500EQ5]GOTO9\nN9M30\n");
    const auto& facts = workspace->programs().front().facts();
    EXPECT_FALSE(facts.all<dataflow::Comparison>().back().truth.can_fail); // asked before
    EXPECT_EQ(facts.all<dataflow::Read>()[0].value.origin, facts.all<dataflow::Read>()[2].value.origin);
    // Two bounds that meet leave the number, but nobody knows whether it was rounded on the way.
    EXPECT_EQ(where("[#500GE5]AND[#500LE5]").exactness, Exactness::unknown);
    EXPECT_RANGE(where("[#500GE5]AND[#500LE5]"), 5, 5);
}

TEST(Refine, WhatIsEqualToARangeIsInThatRange) {
    const Value value = last_read("#1=#1000*10\nIF[#500EQ#1]GOTO1\nM30\nN1X#500\nM30\n");
    EXPECT_EQ(value.low, 0);
    EXPECT_EQ(value.high, 10);
    EXPECT_EQ(value.constant(), std::nullopt);
}

TEST(Refine, AVariableKeepsTheStoreThatMadeIt) {
    const auto workspace = test::analyse_fanuc("O0001\n#1=#1000*10\nX#1\nIF[#1NE5]GOTO9\nX#1\nN9M30\n");
    const auto& reads = workspace->programs().front().facts().all<dataflow::Read>();
    EXPECT_NE(reads.front().value.origin, 0U);
    EXPECT_EQ(reads.front().value.origin, reads.back().value.origin);
}

TEST(Refine, AComparisonThatZeroDoesNotPassTellsThatTheVariableIsSet) {
    EXPECT_EQ(where("#500GT0").vacancy, Vacancy::set);
    EXPECT_EQ(where("#500GE0").vacancy, Vacancy::unknown);
    EXPECT_EQ(where("#500LT0").vacancy, Vacancy::set);
    EXPECT_EQ(where("#500LE0").vacancy, Vacancy::unknown);
    EXPECT_EQ(where("#500GT-1").vacancy, Vacancy::unknown);
    EXPECT_EQ(where("#500LT0.5").vacancy, Vacancy::unknown);
    EXPECT_EQ(where("#500EQ0").vacancy, Vacancy::set); // vacant is not equal to 0
    EXPECT_EQ(where("#500NE0").vacancy, Vacancy::unknown);
    EXPECT_EQ(where("#500NE5").vacancy, Vacancy::unknown);
    EXPECT_EQ(where("#500EQ#501").vacancy, Vacancy::unknown);
}

TEST(Refine, AVacancyTestSplitsVacantFromSet) {
    EXPECT_EQ(where("#500EQ#0").vacancy, Vacancy::vacant);
    EXPECT_EQ(where("#500NE#0").vacancy, Vacancy::set);
    EXPECT_EQ(where("NOT[#500NE#0]").vacancy, Vacancy::vacant);
    EXPECT_RANGE(where("#500EQ#0"), 0, 0); // what it counts as
    EXPECT_RANGE(where("#500NE#0"), -infinity, infinity);
}

/// Arguments may be missing: for that there is a reason until the program has asked.
TEST(Refine, AQuestionEndsTheDoubt) {
    const auto argument = [](const std::string& condition) {
        return last_read("IF[" + condition + "]GOTO9\nX#24\nM99\nN9M99\n");
    };
    const Value doubtful = argument("#25EQ#0");
    EXPECT_EQ(doubtful.vacancy, Vacancy::maybe);
    EXPECT_NE(doubtful.vacancy_origin, 0U);
    for (const std::string asked : {"#24EQ#0", "#24LE0", "#24NE3"}) {
        EXPECT_EQ(argument(asked).vacancy, Vacancy::set) << asked;
        EXPECT_EQ(argument(asked).vacancy_origin, 0U) << asked;
    }
    EXPECT_EQ(argument("#24NE#0").vacancy, Vacancy::vacant);
    EXPECT_NE(argument("#24NE#0").vacancy_origin, 0U);
    EXPECT_EQ(argument("#24EQ0").vacancy, Vacancy::maybe);
}

TEST(Refine, WhatIsNotZeroButPerhapsVacantMayStillCountAsZero) {
    EXPECT_FALSE(where("#500NE0").nonzero);
    EXPECT_TRUE(where("[#500NE#0]AND[#500NE0]").nonzero);
    EXPECT_FALSE(where("[#500NE#0]AND[#500NE5]").nonzero);
    // #501 counts as 0 and may be vacant; #1 may be the 0 that differs from vacant.
    EXPECT_RANGE(
        last_read("#1=#1000*10\nIF[#501LT0]GOTO9\nIF[#501GT0]GOTO9\nIF[#1EQ#501]GOTO9\nX#1\nN9M30\n"), 0, 10);
}

TEST(Refine, OneOfAFewNumbersThatMayBeVacantIsNotKnownToBeSet) {
    // 0 or vacant, or 4.
    const std::string zero_or_4 = "IF[#500EQ1]GOTO1\nIF[#100LT0]GOTO9\nIF[#100GT0]GOTO9\nGOTO2\nN1#100=4\n";
    const dataflow::Value zero = last_read(zero_or_4 + "N2IF[#100GT2]GOTO9\nX#100\nN9M30\n");
    EXPECT_RANGE(zero, 0, 0);
    EXPECT_EQ(zero.vacancy, Vacancy::unknown);
    EXPECT_EQ(zero.choices, 0U);
    const dataflow::Value four = last_read(zero_or_4 + "N2IF[#100LT2]GOTO9\nX#100\nN9M30\n");
    EXPECT_EQ(four.constant(), 4);
    EXPECT_EQ(four.vacancy, Vacancy::set);
}

TEST(Refine, NobodyComesWhereNoNumberIsLeft) {
    const auto reads_of = [](const std::string& conditions) {
        const auto workspace = test::analyse_fanuc("O0001\n#1=#1000*10\n" + conditions + "X#1\nN9M30\n");
        return workspace->programs().front().facts().all<dataflow::Read>().back().use;
    };
    EXPECT_EQ(reads_of("IF[#1LT4]GOTO9\nIF[#1GE4]GOTO9\n"), dataflow::Use::comparison);
    EXPECT_EQ(reads_of("IF[#1LT4]GOTO9\nIF[#1GT4]GOTO9\n"), dataflow::Use::word);
    EXPECT_EQ(reads_of("IF[#1LE4]GOTO9\nIF[#1GE5]GOTO9\n"), dataflow::Use::comparison); // whole numbers
}

} // namespace
} // namespace maclint
