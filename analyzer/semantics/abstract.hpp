//! What can be known of a value before the program runs, and what operators and functions make of that.
#pragma once

#include "analyzer/program/model.hpp"
#include "analyzer/semantics/range.hpp"

#include <cstdint>
#include <optional>

namespace maclint::semantics {

/// `maybe` is known to be possible; `unknown` is ignorance and proves nothing.
enum class Vacancy : std::uint8_t { set, vacant, maybe, unknown };

/// Whether rounding has touched a value.
enum class Exactness : std::uint8_t { exact, unknown, rounded };

/// All that a variable can hold: vacant or not, numbers within the range. The range of what can be vacant
/// holds 0, for which arithmetic takes it.
struct AbstractValue : Range {
    Vacancy vacancy = Vacancy::unknown;
    Exactness exactness = Exactness::unknown;
    bool integer = false;
    bool nonzero = false; ///< known not to be 0 although the range holds it

    [[nodiscard]] std::optional<double> constant() const {
        return low == high && vacancy != Vacancy::vacant && vacancy != Vacancy::maybe ? std::optional(low)
                                                                                      : std::nullopt;
    }
    /// Vacant counts as 0, as it does in arithmetic.
    [[nodiscard]] bool can_be(double number) const {
        const bool may_be_vacant = vacancy == Vacancy::vacant || vacancy == Vacancy::maybe;
        if (number == 0 && may_be_vacant) return true;
        return low <= number && number <= high && !(nonzero && number == 0);
    }
    friend bool operator==(const AbstractValue&, const AbstractValue&) = default;
};

/// A number that stands in the program.
[[nodiscard]] AbstractValue of_number(double number);
[[nodiscard]] AbstractValue of_vacant();

/// What the result of an operator or function can be; with one operand, `second` is the same as `first`.
[[nodiscard]] AbstractValue compute(Operation operation, const AbstractValue& first,
                                    const AbstractValue& second);
/// Whether it is one whole number, known without doubt: the same as if the number stood there.
[[nodiscard]] bool is_whole_number(const AbstractValue& value);

/// What a variable of the type can hold after the value was stored there.
[[nodiscard]] AbstractValue stored_in(VariableType type, const AbstractValue& value);
/// Whether the variable holds the very number: it fits the type.
[[nodiscard]] bool fits(VariableType type, const AbstractValue& value);

/// Whatever one of the two can be.
[[nodiscard]] AbstractValue join(const AbstractValue& a, const AbstractValue& b);

/// Operations whose result is 0 when an operand is, and so when one is vacant.
[[nodiscard]] bool keeps_zero(Operation operation);
/// a+b and b+a are one value.
[[nodiscard]] bool is_commutative(Operation operation);

} // namespace maclint::semantics
