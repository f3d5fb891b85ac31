//! The letter O among figures, in blocks that cannot be parsed for it.
#pragma once

#include "analyzer/dialect/fanuc/lexer.hpp"
#include "analyzer/program/syntax_error.hpp"

#include <optional>
#include <span>
#include <string_view>

namespace maclint::fanuc {

/// `R1O.`, `AO`, `#1=O.5`, `IF[#1EQO]`: the first letter O of the tokens that can only be a figure 0.
[[nodiscard]] std::optional<SyntaxError> find_letter_o(std::string_view text, std::span<const Token> tokens);

} // namespace maclint::fanuc
