//! Says why a block cannot be read, in the user's words.
#pragma once

#include "analyzer/dialect/sinumerik/open_program.hpp"
#include "analyzer/program/model.hpp"
#include "analyzer/syntax/tree.hpp"

#include <optional>
#include <string_view>

namespace maclint::sinumerik {

/// The cause of an error in a block that its text shows: a text or bracket left open, a placeholder.
[[nodiscard]] std::optional<SyntaxError> find_cause(std::string_view text, Span block);

/// Where the parser gave up, for a block without an evident cause.
[[nodiscard]] SyntaxError find_parse_error(std::string_view text, Span block, const syntax::Tree& tree);

/// What an unreadable block may do, judged by the words in it.
[[nodiscard]] NamedInBlock names_in(OpenProgram& program, Span block);

/// Whether an unreadable block begins with PROC, or with what is meant for it.
[[nodiscard]] bool declares_program(std::string_view text, Span block);

/// Makes a remark of what stands there.
[[nodiscard]] Remedy remark_remedy(Offset begin);
/// The name before the colon of a label, whichever colon it is.
[[nodiscard]] std::string_view label_in(std::string_view written);
/// The colon of Chinese keyboards, which is none.
inline constexpr std::string_view wide_colon = "\xEF\xBC\x9A";

} // namespace maclint::sinumerik
