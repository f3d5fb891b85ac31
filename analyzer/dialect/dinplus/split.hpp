//! Cuts a DIN PLUS file into blocks: lines, comments over several lines, texts.
#pragma once

#include "analyzer/source/span.hpp"

#include <string_view>
#include <vector>

namespace maclint::dinplus {

/// A block as it stands in the file.
struct RawBlock {
    Span span;                  ///< without blanks around it; a comment in it may span lines
    Offset next;                ///< behind its line end
    std::vector<Span> comments; ///< brackets included
    bool open_comment;          ///< the last comment lacks its ']'
    Offset code;                ///< bytes that are neither blank nor comment
};

/// Behind the blanks, the byte order mark and the leader at `at`.
[[nodiscard]] Offset skip_blanks(std::string_view text, Offset at);

/// Behind the slides and skip marks at `at`, and the blanks around them: `$1 /2`.
[[nodiscard]] Offset behind_marks(std::string_view text, Offset at);

/// The block that begins at `begin`, the head of a line. It ends at the line end; a comment that nobody
/// closes ends with the line before which blocks visibly begin again.
void cut_block(std::string_view text, Offset begin, RawBlock& block);

/// Whether the line at `at` looks like a block, whatever stands before it: a block number with something
/// behind it, or a section word.
[[nodiscard]] bool begins_block(std::string_view text, Offset at);

/// The words at `at`, in any case and with blanks between them, as far as they reach; the first has three
/// letters or more.
[[nodiscard]] Span words_at(std::string_view text, Offset at);

} // namespace maclint::dinplus
