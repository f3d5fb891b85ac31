//! Value numbers: what counts as one number, and what a symbol stands for.
#include "analyzer/dataflow/domain/value.hpp"

#include <array>

#include <gtest/gtest.h>

namespace maclint::dataflow {
namespace {

TEST(ValueTable, HasOneSymbolForANumberAndOneZero) {
    ValueTable table;
    EXPECT_EQ(table.constant(2.5), table.constant(2.5));
    EXPECT_NE(table.constant(2.5), table.constant(-2.5));
    EXPECT_EQ(table.constant(0), table.constant(-0.0));
    EXPECT_EQ(table.number_of(table.constant(2.5)), 2.5);
    EXPECT_EQ(table.number_of(table.constant(-0.0)), 0);
}

TEST(ValueTable, TellsWhatASymbolStandsFor) {
    ValueTable table;
    const SymbolId unknown = table.symbols(Symbol::opaque(5, 6, 7));
    const SymbolId group = table.symbols(Symbol::group_at_entry(3));
    const SymbolId if_set = table.symbols(Symbol::value_if_set(unknown, 1, 2));
    EXPECT_EQ(table.number_of(unknown), std::nullopt);
    EXPECT_EQ(table.number_of(group), std::nullopt);
    EXPECT_EQ(table.entry_group_of(group), GroupId{3});
    EXPECT_EQ(table.entry_group_of(unknown), std::nullopt);
    EXPECT_EQ(table.asked_for(if_set), unknown);
    EXPECT_EQ(table.asked_for(group), group);
    EXPECT_NE(table.constant(0), 0U); // the symbol of which nobody knows anything
    table.fit();
    EXPECT_EQ(table.entry_group_of(group), GroupId{3});
}

TEST(ValueTable, OfAFewNumbersTheLastOneThatIsLeftIsTheValue) {
    ValueTable table;
    Value few = number_value(table, 5);
    few.choices = table.either(number_value(table, 0), number_value(table, 5));
    few.symbol = table.symbols(Symbol::joined_at(1, 2));
    few.low = 0;
    const auto left = [&](double number, Vacancy vacancy) {
        Value value = few;
        value.vacancy = vacancy;
        table.narrow(value, std::array{number});
        return value.symbol == table.constant(number);
    };
    EXPECT_TRUE(left(5, Vacancy::set));
    EXPECT_TRUE(left(0, Vacancy::set));
    EXPECT_TRUE(left(5, Vacancy::maybe));  // what is vacant is no 5
    EXPECT_FALSE(left(0, Vacancy::maybe)); // and counts as 0
}

TEST(Interner, MayBeAskedForAThingThatItHolds) {
    // Also when there is no room left: under a sanitizer, whoever moves the things first is found out.
    Interner<Value> values;
    for (std::uint32_t id = 0; id < 1000; ++id) {
        Value value;
        value.symbol = id;
        EXPECT_EQ(values(value), id);
        EXPECT_EQ(values(values[id / 2]), id / 2);
        EXPECT_EQ(values[0].symbol, 0U);
    }
}

TEST(Values, OfNumbersAreSetAndExact) {
    ValueTable table;
    for (const double number : {-3.0, 0.0, 2.5}) {
        const Value value = number_value(table, number);
        EXPECT_EQ(value.symbol, table.constant(number));
        EXPECT_EQ(value.constant(), number);
        EXPECT_EQ(value.vacancy, Vacancy::set);
        EXPECT_EQ(value.exactness, Exactness::exact);
        EXPECT_EQ(value.integer, number != 2.5);
        EXPECT_TRUE(value.can_be(number));
        EXPECT_FALSE(value.can_be(number + 1));
    }
}

TEST(Values, OfVacantCountAsZeroAndAreNoNumber) {
    ValueTable table;
    const Value vacant = vacant_value(table, 9);
    EXPECT_EQ(vacant.vacancy, Vacancy::vacant);
    EXPECT_EQ(vacant.vacancy_origin, 9U);
    EXPECT_EQ(vacant.low, 0);
    EXPECT_EQ(vacant.high, 0);
    EXPECT_EQ(vacant.constant(), std::nullopt);
    EXPECT_TRUE(vacant.can_be(0));
    EXPECT_TRUE(vacant.integer);
    EXPECT_EQ(vacant.exactness, Exactness::exact);
    EXPECT_EQ(vacant.symbol, vacant_value(table, 10).symbol); // vacant is equal to vacant
    EXPECT_NE(vacant.symbol, table.constant(0));
}

} // namespace
} // namespace maclint::dataflow
