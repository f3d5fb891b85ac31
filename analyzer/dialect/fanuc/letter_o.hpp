//! The letter O among figures, in blocks that cannot be parsed for it.
#pragma once

#include "analyzer/dialect/fanuc/lexer.hpp"
#include "analyzer/program/syntax_error.hpp"

#include <optional>
#include <span>
#include <string_view>

namespace maclint::fanuc {

/// `O1002`, with so many figures or more, is the number of a program and no number with a letter O in it.
constexpr std::size_t digits_of_program = 4;

/// `R1O.`, `AO`, `#1=O.5`, `IF[#1EQO]`: the first letter O of the tokens that can only be a figure 0.
[[nodiscard]] std::optional<SyntaxError> find_letter_o(std::string_view text, std::span<const Token> tokens);

/// `G0TO5`, when this is its word `TO5`: a GOTO with the figure 0 for its first O, or a tool with the letter
/// O.
[[nodiscard]] std::optional<Span> find_jump_with_zero(std::string_view text, Span word);

} // namespace maclint::fanuc
