//! Indices that are made of the value of an offset where its number is meant.
#pragma once

#include "analyzer/program/model.hpp"

#include <vector>

namespace maclint::rules {

/// The value of a system variable in a sum that picks a variable: `#[#2400+#7]`.
struct ValueForNumber {
    ExpressionId index;
    ExpressionId value; ///< #2400
};

/// Sums with the value of an offset, or of another number of the machine that keeps what is stored: what is
/// added to it makes a number of no variable that anybody means. In the order of the expressions.
[[nodiscard]] std::vector<ValueForNumber> find_values_for_numbers(const Program& program);

} // namespace maclint::rules
