//! Why a block could not be read, in the user's words, and what it may do all the same.
#pragma once

#include "analyzer/program/model.hpp"
#include "analyzer/syntax/tree.hpp"

#include <optional>
#include <vector>

namespace maclint::fanuc {

/// What a block that could not be read names: places that it may write, labels that it may jump to.
[[nodiscard]] UnreadableBlock names_in(const Program& program, Span block);

/// Whether a block is worth parsing. In what people write, a digit is never far; the parser's time grows with
/// the square of a row of letters or signs without one.
[[nodiscard]] bool is_plausible(std::string_view text, Span block);

/// Adds the cause of the errors in a block's tree; always one.
void diagnose(std::string_view text, Span block, const syntax::Tree& tree,
              std::vector<Irregularity>& irregularities);

/// A comment that stands where only a bracket makes sense: `X(#1+2)`, `SIN(30)`.
[[nodiscard]] std::optional<Irregularity> find_parenthesis_as_bracket(std::string_view text, Span block);

} // namespace maclint::fanuc
