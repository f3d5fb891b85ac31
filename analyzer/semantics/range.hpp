//! Ranges of numbers, and where the results of operators and functions lie.
#pragma once

#include "analyzer/program/model.hpp"

#include <limits>

namespace maclint::semantics {

/// The bound of a range where none is known.
inline constexpr double infinity = std::numeric_limits<double>::infinity();

/// The numbers from `low` to `high`, both included.
struct Range {
    double low = -infinity;
    double high = infinity;
    friend bool operator==(const Range&, const Range&) = default;
};

/// Where the result lies for operands within these ranges, as far as there is one; any number where nothing
/// is known of the operation. `second` is not looked at where there is one operand.
[[nodiscard]] Range range_of(Operation operation, const Range& first, const Range& second);

} // namespace maclint::semantics
