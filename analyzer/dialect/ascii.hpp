//! Small questions about the words of a text that every dialect asks.
#pragma once

#include "analyzer/source/span.hpp"

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace maclint {

/// ASCII letters become capitals.
[[nodiscard]] std::string in_capitals(std::string_view text);

/// The text of a block as controls read it: in capitals, without blanks and line ends; what stands in
/// quotation marks stays as it is.
[[nodiscard]] std::string without_blanks(std::string_view text);

/// Edits (insert, delete, change, swap of neighbours) between two words of at most 16 bytes; `most` + 1 when
/// they are more than `most`, or a word is longer.
[[nodiscard]] std::size_t edit_distance(std::string_view a, std::string_view b, std::size_t most);

/// Whether a comment speaks to maclint: it holds the name, any case.
[[nodiscard]] bool addresses_maclint(std::string_view comment);

/// Writes a block without its comments, blanks and tape leader into `rest`, whose memory is used again.
void take_out_comments(std::string_view text, Span block, std::span<const Span> comments, std::string& rest);

/// What stands behind the last '/' of a path. A path of Windows has been given that already; elsewhere '\' is
/// a letter of names as any other.
[[nodiscard]] std::string_view file_name_of(std::string_view path);

/// A file's name without folder and extension.
[[nodiscard]] std::string stem_of(std::string_view path);

} // namespace maclint
