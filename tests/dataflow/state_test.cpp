//! What is known where paths meet, at a program's start, and after everything may have changed: worked out by
//! hand from what each path stores.
#include "analyzer/dataflow/facts/read.hpp"
#include "analyzer/dataflow/facts/store.hpp"
#include "tests/support/analysed.hpp"
#include "tests/support/hand_built.hpp"

#include <array>
#include <optional>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint {
namespace {

using dataflow::Exactness;
using dataflow::Origin;
using dataflow::Vacancy;
using dataflow::Value;
using test::HandBuilt;
namespace rows = test::rows;

/// What `#1` is known to be where a path with one block and a path with another meet, whichever comes first.
Value after_either(const std::string& one, const std::string& other) {
    const auto after = [](const std::string& fallen, const std::string& jumped) {
        const auto workspace = test::analyse_fanuc("O0001\nIF[#500EQ1]GOTO1\n" + fallen + "\nGOTO2\nN1" +
                                                   jumped + "\nN2X#1\nM30\n");
        return workspace->programs().front().facts().all<dataflow::Read>().back().value;
    };
    const Value found = after(one, other);
    const Value exchanged = after(other, one);
    EXPECT_EQ(found.low, exchanged.low);
    EXPECT_EQ(found.high, exchanged.high);
    EXPECT_EQ(found.vacancy, exchanged.vacancy);
    EXPECT_EQ(found.exactness, exchanged.exactness);
    EXPECT_EQ(found.integer, exchanged.integer);
    EXPECT_EQ(found.can_be(0), exchanged.can_be(0));
    return found;
}

TEST(Join, IsWhatBothPathsKnow) {
    const Value numbers = after_either("#1=2", "#1=5");
    EXPECT_EQ(numbers.low, 2);
    EXPECT_EQ(numbers.high, 5);
    EXPECT_EQ(numbers.vacancy, Vacancy::set);
    EXPECT_EQ(numbers.exactness, Exactness::exact);
    EXPECT_TRUE(numbers.integer);
    EXPECT_FALSE(after_either("#1=2", "#1=2.5").integer);
    EXPECT_EQ(after_either("#1=7", "#1=7").constant(), 7);
}

TEST(Join, OfNumbersOnBothSidesOfZeroNeedNotHoldIt) {
    EXPECT_FALSE(after_either("#1=-1", "#1=1").can_be(0));
    EXPECT_TRUE(after_either("#1=0", "#1=1").can_be(0));
    EXPECT_TRUE(after_either("#1=#0", "#1=1").can_be(0)); // vacant counts as 0
}

TEST(Join, OfAVacantAndASetVariableMayBeEither) {
    const Value either = after_either("#1=#0", "#1=4");
    EXPECT_EQ(either.vacancy, Vacancy::maybe);
    EXPECT_FALSE(either.constant());
}

TEST(Join, IsRoundedWhereOnePathRounds) {
    const Value either = after_either("#1=1/3", "#1=4");
    EXPECT_EQ(either.exactness, Exactness::rounded);
    EXPECT_NE(either.rounding, 0U);
}

/// Where it comes from that #1 may be vacant in the last word.
Origin vacancy_origin_of_last_read(const std::string& text) {
    const auto workspace = test::analyse_fanuc(text);
    const ProgramAnalysis& analysis = workspace->programs().front();
    return analysis.data().origin(analysis.facts().all<dataflow::Read>().back().value.vacancy_origin);
}

TEST(Join, ThatTheVariableItselfWasLeftOutSaysMoreThanThatAnotherWas) {
    // Argument A is #1 and argument B is #2.
    for (const std::string text : {"O9001\nIF[#500EQ1]GOTO1\n#1=#2\nN1X#1\nM99\n",
                                   "O9001\nIF[#500EQ1]GOTO1\nGOTO2\nN1#1=#2\nN2X#1\nM99\n"}) {
        const Origin origin = vacancy_origin_of_last_read(text);
        EXPECT_EQ(origin.kind, Origin::Kind::entry) << text;
        EXPECT_EQ(origin.id, 1U) << text;
    }
    EXPECT_EQ(vacancy_origin_of_last_read("O9001\n#1=#2\nX#1\nM99\n").id, 2U);
}

TEST(Widening, StopsAtTheNextNumberThatTheProgramComparesWith) {
    const auto workspace = test::analyse_fanuc("O0001\n#1=0\nM30\n");
    const ProgramAnalysis& analysis = workspace->programs().front();
    dataflow::States states(analysis.program(), analysis.data().knowledge());
    const Variable variable = analysis.facts().all<dataflow::Store>().front().variable;
    const auto holding = [&](double low, double high) {
        Value value;
        value.vacancy = Vacancy::set;
        value.low = low;
        value.high = high;
        dataflow::State state = states.at_entry();
        states.write(state, variable, value);
        return state;
    };
    const auto widened = [&](double low, double high) {
        const std::array thresholds{-9., -5., 0., 5., 9.};
        return states.read(states.widen(holding(0, 1), holding(low, high), 0, thresholds), variable);
    };
    EXPECT_EQ(widened(0, 3).high, 5);
    EXPECT_EQ(widened(0, 5).high, 5);
    EXPECT_EQ(widened(0, 6).high, 9);
    EXPECT_EQ(widened(0, 10).high, semantics::infinity);
    EXPECT_EQ(widened(0, 10).low, 0);
    EXPECT_EQ(widened(-3, 1).low, -5);
    EXPECT_EQ(widened(-5, 1).low, -5);
    EXPECT_EQ(widened(-10, 1).low, -semantics::infinity);
    EXPECT_EQ(widened(-10, 1).high, 1);
}

TEST(Entry, OfAProgramThatNobodyCallsHasNoLocalsButItsArguments) {
    const auto workspace = test::analyse_fanuc("O9001\nX#1Y#10Z#100\nM99\n");
    const auto& reads = workspace->programs().front().facts().all<dataflow::Read>();
    ASSERT_EQ(reads.size(), 3U);
    EXPECT_EQ(reads[0].value.vacancy, Vacancy::maybe);
    EXPECT_TRUE(reads[0].value.can_be(0));
    EXPECT_EQ(reads[1].value.vacancy, Vacancy::vacant); // no letter means #10
    EXPECT_EQ(reads[2].value.vacancy, Vacancy::unknown);
}

TEST(Entry, WhatTheControlOwnsIsNeverVacant) {
    for (const std::string variable : {"#5041", "#1100", "#2001", "#5221", "[#_DATE]"}) {
        const auto workspace = test::analyse_fanuc("O0001\n#1=" + variable + "\nM30\n");
        EXPECT_EQ(workspace->programs().front().facts().all<dataflow::Store>()[0].value.vacancy, Vacancy::set)
            << variable;
    }
}

// ---- after everything of a kind may have changed

TEST(Forgetting, IsOfTheCommonsAloneAndOfEachCallAnew) {
    const auto workspace =
        test::analyse_fanuc("O0001\nG65P77\n#1=#100\n#2=#100\nG65P77\n#3=#100\n#4=#1\nM30\n");
    const auto& stores = workspace->programs().front().facts().all<dataflow::Store>();
    ASSERT_EQ(stores.size(), 4U);
    EXPECT_EQ(stores[0].value.symbol, stores[1].value.symbol); // nothing ran between the two
    EXPECT_NE(stores[1].value.symbol, stores[2].value.symbol); // the second call did
    EXPECT_EQ(stores[3].value.symbol, stores[0].value.symbol); // a local is not forgotten
}

TEST(Forgetting, EndsWithTheNextStore) {
    const auto workspace = test::analyse_fanuc("O0001\nG65P77\n#100=3\nX#100\nM30\n");
    EXPECT_EQ(workspace->programs().front().facts().all<dataflow::Read>().back().value.constant(), 3);
}

TEST(Forgetting, OnOnePathIsForgettingWherePathsMeet) {
    const auto workspace =
        test::analyse_fanuc("O0001\n#1=#100\nIF[#500EQ1]GOTO1\nG65P77\nN1#2=#100\n#3=#100\nM30\n");
    const auto& stores = workspace->programs().front().facts().all<dataflow::Store>();
    ASSERT_EQ(stores.size(), 3U);
    EXPECT_NE(stores[0].value.symbol, stores[1].value.symbol);
    EXPECT_EQ(stores[1].value.symbol, stores[2].value.symbol);
}

// ---- declared types

/// What a declared variable holds after R1 was stored in it, which is 0 or `largest`.
Value stored_in(VariableType type, double largest) {
    HandBuilt built("MAIN.MPF", "DEF\nR1=0\nIF R5==1 R1=N\nV=R1\nR2=V\nM30\n");
    const Variable v = built.declare("V", type);
    const Variable r1{rows::r, 1};
    built.block({});
    built.block({Assign{r1, built.number(0)}});
    built.block({test::Step(built.apply(Operation::equal, {built.load({rows::r, 5}), built.number(1)}),
                            Assign{r1, built.number(largest)})});
    built.block({Assign{v, built.load(r1)}});
    built.block({Assign{Variable{rows::r, 2}, built.load(v)}});
    built.block({Stop{Stop::Kind::end, std::nullopt}});
    std::vector<WorkspaceFile> files;
    files.push_back(built.finish());
    const auto workspace = test::analyse(std::move(files), {.complete = true, .jobs = 1});
    return workspace->programs().front().facts().all<dataflow::Read>().back().value;
}

TEST(DeclaredTypes, ATruthIsZeroOrOne) {
    for (const double largest : {1.0, 2.0, 9.5}) {
        const Value truth = stored_in(VariableType::truth, largest);
        EXPECT_EQ(truth.low, 0) << largest;
        EXPECT_EQ(truth.high, 1) << largest;
        EXPECT_TRUE(truth.integer) << largest;
    }
    EXPECT_EQ(stored_in(VariableType::truth, -3).low, 0);
    EXPECT_EQ(stored_in(VariableType::truth, -3).high, 1);
}

TEST(DeclaredTypes, AnIntegerIsRounded) {
    const Value integer = stored_in(VariableType::integer, 1.6);
    EXPECT_EQ(integer.low, 0);
    EXPECT_EQ(integer.high, 2);
    EXPECT_TRUE(integer.integer);
    EXPECT_EQ(integer.exactness, Exactness::exact);
    EXPECT_EQ(integer.rounding, 0U);
    EXPECT_EQ(stored_in(VariableType::integer, -1.6).low, -2);
    EXPECT_EQ(stored_in(VariableType::integer, 7).high, 7);
    EXPECT_EQ(stored_in(VariableType::number, 1.6).high, 1.6);
}

/// What a program knows of a parameter of the type before it has stored anything in it.
Value at_entry(VariableType type) {
    HandBuilt built("P.SPF", "PROC P(A)\nR1=A\nRET\n");
    const Variable a = built.formal("A", type, Passing::by_value);
    built.block({});
    built.block({Assign{Variable{rows::r, 1}, built.load(a)}});
    built.block({Return{}});
    std::vector<WorkspaceFile> files;
    files.push_back(built.finish());
    const auto workspace = test::analyse(std::move(files), {.complete = false, .jobs = 1});
    return workspace->programs().front().facts().all<dataflow::Read>().back().value;
}

TEST(DeclaredTypes, AreThoseOfParametersToo) {
    EXPECT_TRUE(at_entry(VariableType::integer).integer);
    EXPECT_FALSE(at_entry(VariableType::number).integer);
    EXPECT_TRUE(at_entry(VariableType::truth).integer);
    EXPECT_EQ(at_entry(VariableType::truth).low, 0);
    EXPECT_EQ(at_entry(VariableType::truth).high, 1);
    EXPECT_LT(at_entry(VariableType::integer).low, -1e9);
}

} // namespace
} // namespace maclint
