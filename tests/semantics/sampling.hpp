//! Chosen abstract values, and contents that they allow: what is said of the first is held against the
//! second.
#pragma once

#include "analyzer/semantics/abstract.hpp"
#include "analyzer/semantics/concrete.hpp"
#include "tests/support/dice.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <ostream>
#include <string>

namespace maclint::semantics {

/// Whether a variable of which that is known can hold the content.
inline bool allows(const AbstractValue& value, Content content) {
    if (!content) return value.vacancy != Vacancy::set;
    const bool whole = std::floor(*content) == *content;
    return value.vacancy != Vacancy::vacant && value.low <= *content && *content <= value.high &&
           (whole || !value.integer) && (*content != 0 || !value.nonzero);
}

inline std::string spell(Content content) { return content ? std::to_string(*content) : "vacant"; }

inline std::ostream& operator<<(std::ostream& out, const AbstractValue& value) {
    return out << (value.integer ? "whole " : "") << value.low << " to " << value.high << ", vacancy "
               << static_cast<int>(value.vacancy) << ", exactness " << static_cast<int>(value.exactness)
               << (value.nonzero ? ", not 0" : "");
}

class Sampler {
  public:
    /// Some abstract value that allows at least one content.
    AbstractValue value() {
        AbstractValue value;
        value.vacancy = dice_.one_of(
            std::array{Vacancy::set, Vacancy::set, Vacancy::vacant, Vacancy::maybe, Vacancy::unknown});
        if (value.vacancy == Vacancy::vacant) return of_vacant();
        value.low = dice_.one_of(bounds_);
        value.high = dice_.one_of(bounds_);
        if (value.high < value.low || dice_.one_in(3)) value.high = value.low;
        if (std::isinf(value.low) && value.low == value.high) value = {{}, value.vacancy};
        value.exactness = dice_.one_of(
            std::array{Exactness::exact, Exactness::exact, Exactness::unknown, Exactness::rounded});
        if (value.vacancy != Vacancy::set) { // arithmetic takes it for 0
            value.low = std::min(value.low, 0.0);
            value.high = std::max(value.high, 0.0);
        }
        value.integer =
            std::floor(value.low) == value.low && std::floor(value.high) == value.high && dice_.one_in(2);
        value.nonzero = value.vacancy == Vacancy::set && value.low < 0 && value.high > 0 && dice_.one_in(3);
        return value;
    }

    /// Something that the value allows, one of its bounds as often as not.
    Content content(const AbstractValue& value) {
        constexpr double far = 2000; // beyond all bounds
        if (value.vacancy == Vacancy::vacant) return {};
        if (value.vacancy != Vacancy::set && dice_.one_in(3)) return {};
        const double low = std::max(value.low, -far);
        const double high = std::min(value.high, far);
        double number = dice_.one_in(4) ? low : high;
        if (dice_.one_in(2)) number = std::min(low + (high - low) * dice_.between(0, 64) / 64, high);
        if (value.integer) number = std::floor(number);
        return value.nonzero && number == 0 ? low : number;
    }

    test::Dice& dice() { return dice_; }

  private:
    static constexpr std::array<double, 18> bounds_{-infinity, -1000, -9,  -8, -2.5, -1, -0.1, 0,   0,
                                                    0.1,       0.5,   1.5, 2,  3,    4,  7.25, 100, infinity};
    test::Dice dice_{20};
};

/// Every operation that makes a number of one or two numbers.
constexpr auto unary_operations = std::to_array<Operation>(
    {Operation::negate, Operation::bit_not, Operation::sine, Operation::cosine, Operation::tangent,
     Operation::arc_sine, Operation::arc_cosine, Operation::arc_tangent, Operation::square_root,
     Operation::absolute, Operation::round, Operation::truncate, Operation::round_up, Operation::logarithm,
     Operation::exponential, Operation::to_binary, Operation::to_decimal_code});
constexpr auto binary_operations =
    std::to_array<Operation>({Operation::add, Operation::subtract, Operation::multiply, Operation::divide,
                              Operation::modulo, Operation::power, Operation::bit_and, Operation::bit_or,
                              Operation::bit_xor, Operation::arc_tangent_of_two});
constexpr auto comparisons =
    std::to_array<Operation>({Operation::equal, Operation::not_equal, Operation::less, Operation::less_equal,
                              Operation::greater, Operation::greater_equal});

} // namespace maclint::semantics
