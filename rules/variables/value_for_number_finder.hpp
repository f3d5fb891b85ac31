//! Indices that are made of the value of an offset where its number is meant, or of a number where a value
//! is.
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

/// A local variable taken away from a number of one, in an index: `#[18-#31]`.
struct NumberForValue {
    ExpressionId index;
    Variable first;
    ExpressionId second; ///< #31
};

/// Such differences in the words of blocks, of programs that read the first variable elsewhere and reach none
/// of their local variables by index otherwise. In text order.
[[nodiscard]] std::vector<NumberForValue> find_numbers_for_values(const Program& program);

/// Comparisons of two variables that hold nothing but numbers of variables: `#1=700+#20`, `#2=800+#20`,
/// `#[#1]=#[#1]+1`, `IF[#1LT#2]`. Each of the two is set once, to a sum with such a number, so that nothing
/// counts it, and one is an index elsewhere. In the order of the expressions.
[[nodiscard]] std::vector<ExpressionId> find_numbers_compared(const Program& program);

/// `IF[#1LT#11]` with #1=600+#20, which is an index elsewhere: the number of a variable against an argument.
struct NumberAgainstLimit {
    ExpressionId comparison;
    ExpressionId number; ///< #1
    ExpressionId limit;  ///< #11
};

/// Such comparisons by less or more, of numbers that nothing counts. In the order of the expressions.
[[nodiscard]] std::vector<NumberAgainstLimit> find_numbers_against_limits(const Program& program);

/// Variables that hold nothing but the number of a variable, in a sum that a variable chosen by its number
/// gets:
/// `#10=5221+20*#1`, `#[#11]=#10+#24`, where another block says #[#10]. In text order.
[[nodiscard]] std::vector<ExpressionId> find_numbers_stored(const Program& program);

} // namespace maclint::rules
