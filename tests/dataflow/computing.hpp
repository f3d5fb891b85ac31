//! Values for tests of operations, and operations on them.
#pragma once

#include "tests/dataflow/expect.hpp"

#include <array>
#include <cstdint>

#include <gtest/gtest.h>

namespace maclint::dataflow {

class Arithmetic : public testing::Test {
  protected:
    ValueTable table;

    Value range(double low, double high) {
        Value value;
        value.symbol = table.symbols(Symbol::opaque(++values_));
        value.low = low;
        value.high = high;
        value.vacancy = Vacancy::set;
        value.exactness = Exactness::exact;
        return value;
    }
    Value whole(double low, double high) {
        Value value = range(low, high);
        value.integer = true;
        return value;
    }
    Value number(double value) { return number_value(table, value); }
    Value with(Exactness exactness, Value value) {
        value.exactness = exactness;
        return value;
    }
    Value with(Vacancy vacancy, Value value) {
        value.vacancy = vacancy;
        return value;
    }
    /// Where another expression has rounded it.
    Value rounded_before() {
        Value value = with(Exactness::rounded, whole(0, 9));
        value.rounding = table.origins({Origin::Kind::expression, 77, 0});
        return value;
    }

    static constexpr Origin here{Origin::Kind::expression, 1, 0};
    Value apply(Operation operation, const Value& a) {
        return compute(table, operation, std::array{a}, here);
    }
    Value apply(Operation operation, const Value& a, const Value& b) {
        return compute(table, operation, std::array{a, b}, here);
    }

  private:
    std::uint64_t values_ = 0;
};

} // namespace maclint::dataflow
