//! Numbers that stand where a variable of that number is meant.
#pragma once

#include "analyzer/program/model.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace maclint::rules {

/// The whole number that the expression is, written without a point, and that a variable can have.
[[nodiscard]] std::optional<std::int64_t> number_of_a_variable(const Program& program, ExpressionId id);

/// Whether the program's text holds the variable of that number.
[[nodiscard]] bool names_variable(const Program& program, std::int64_t number);

struct BareNumber {
    std::int64_t number;
    Span span; ///< `[517]`, `X18`
    Span
        sibling; ///< `F[#517]`, `X#18`: a word of the same letter; empty: only other blocks name the variable
    bool is_set_in_vain = false; ///< the variable, whose number stands in a calculation
};

/// Numbers alone in brackets, where the program names the variable of that number, small ones in calculations
/// where it reads that argument; and words whose number has
/// no point while those of all others do, where a word of the same letter takes that variable; and numbers in
/// calculations and arguments, where the program sets the variable of that number, or asks whether it was
/// passed, and nothing reads it; where a statement sets the variable to a sum of numbers (`#101=101+1`);
/// where the word's letter passes it and another word of the block adds to its own (`X[24+#1] Y[#25+#2]`), or
/// nothing but numbers are calculated (`Q[17/2]`); or where another word of the block takes the variable
/// beside it in number, and the program sets that one, too (`X[#101*#4] Y[102+#5]`). In text order, each
/// place once.
[[nodiscard]] std::vector<BareNumber> find_bare_numbers(const Program& program);

} // namespace maclint::rules
