//! Why a block could not be read, in the user's words, and what it may do all the same.
#pragma once

#include "analyzer/program/builder.hpp"
#include "analyzer/syntax/tree.hpp"

#include <optional>
#include <string_view>
#include <vector>

namespace maclint::fanuc {

/// What a block that could not be read names: variables that it may write, labels that it may jump to.
[[nodiscard]] NamedInBlock names_in(const Program& program, Span block);

/// Whether the block is text after a sign that begins a remark on other controls.
[[nodiscard]] bool is_bare_remark(std::string_view text, Span block);

/// What is wrong with a block that does not parse, told from its text alone; none where only the parser can
/// say what it stumbled over.
[[nodiscard]] std::optional<SyntaxError> find_cause(std::string_view text, Span block);

/// Where the parser stumbled, for a block without a cause of its own.
[[nodiscard]] SyntaxError find_parse_error(std::string_view text, Span block, const syntax::Tree& tree);

/// What to say of a word that the language does not have.
[[nodiscard]] SyntaxError unknown_word(std::string_view text, Span word);

/// A comment that stands where only a bracket makes sense: `X(#1+2)`, `SIN(30)`.
[[nodiscard]] std::optional<SyntaxError> find_parenthesis_as_bracket(std::string_view text, Span block);

} // namespace maclint::fanuc
