//! Causes of syntax errors that the tokens of a block show, one question each.
#pragma once

#include "analyzer/dialect/fanuc/lexer.hpp"
#include "analyzer/program/syntax_error.hpp"

#include <optional>
#include <span>
#include <string_view>

namespace maclint::fanuc {

/// Whether a block is a macro statement: behind its marks and its number a variable or a keyword stands.
[[nodiscard]] bool begins_statement(std::string_view text, std::span<const Token> block);

/// `N G1 X5.`, `O(SPARE)`
[[nodiscard]] std::optional<SyntaxError> find_missing_number(std::string_view text,
                                                             std::span<const Token> block);
/// `X10. O1002`
[[nodiscard]] std::optional<SyntaxError> find_misplaced_program_number(std::string_view text,
                                                                       std::span<const Token> block);
/// `#5 EQ 3`
[[nodiscard]] std::optional<SyntaxError> find_missing_equals(std::string_view text,
                                                             std::span<const Token> block);
/// `#1=[#2][#3]`, `#1=ATAN[#2][#3]`
[[nodiscard]] std::optional<SyntaxError> find_missing_operator(std::string_view text,
                                                               std::span<const Token> block);
/// `DPRNTX#1[53]`, `SETVN510[]`
[[nodiscard]] std::optional<SyntaxError> find_output_fault(std::string_view text,
                                                           std::span<const Token> block);
/// `X20.~`: of the tokens the first that no control knows.
[[nodiscard]] std::optional<SyntaxError> find_foreign_character(std::string_view text,
                                                                std::span<const Token> block);

} // namespace maclint::fanuc
