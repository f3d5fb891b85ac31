//! Lines and columns of a text: where line ends are, and a sparse index from bytes to positions and back.
#pragma once

#include "analyzer/source/encoding.hpp"
#include "analyzer/source/span.hpp"

#include <cstdint>
#include <string_view>
#include <vector>

namespace maclint {

/// A place as editors, SARIF and LSP count it.
struct Position {
    std::uint32_t line = 1;        ///< from 1
    std::uint32_t column = 1;      ///< from 1, in UTF-16 code units; the same everywhere inside one character
    std::uint32_t byte_column = 1; ///< from 1, in bytes

    friend constexpr auto operator<=>(const Position&, const Position&) = default;
};

constexpr bool is_line_end(char c) { return c == '\n' || c == '\r'; }

/// The first line end at or after `offset`, or the end of the text.
[[nodiscard]] constexpr std::size_t find_line_end(std::string_view bytes, std::size_t offset) {
    while (offset < bytes.size() && !is_line_end(bytes[offset])) ++offset;
    return offset;
}

/// The offset after the line end that begins at `offset`: LF, CRLF, CR, or on tape LF CR and LF CR CR.
/// `bytes[offset]` is CR or LF.
[[nodiscard]] Offset after_line_end(std::string_view bytes, Offset offset);

/// Knows the position of one byte in every KiB and counts from there, so a text of 200 MB costs 3 MB
/// more. The text must outlive the index.
class LineIndex {
  public:
    LineIndex(std::string_view bytes, Encoding encoding);

    /// Line ends plus one: the text after the last line end is a line too, even when it is empty.
    [[nodiscard]] std::uint32_t line_count() const { return line_count_; }
    /// Offsets after the end count as the end; those inside the byte order mark as the first character.
    [[nodiscard]] Position position(Offset offset) const;
    /// The line without its line end, and without the byte order mark; lines after the last count as the
    /// last.
    [[nodiscard]] Span line_span(std::uint32_t line) const;
    /// The byte at a line and a UTF-16 column, both from 1; a column after the line's end counts as its end.
    [[nodiscard]] Offset offset_at(std::uint32_t line, std::uint32_t column) const;

  private:
    /// A place from which counting can start: between characters and not inside a line end.
    struct Checkpoint {
        Offset at;
        Offset line_begin;
        std::uint32_t line;
        std::uint32_t units; ///< UTF-16 code units from `line_begin` to `at`
    };

    void build();
    [[nodiscard]] Offset find_line_end(Offset from, Offset to) const;
    [[nodiscard]] std::uint32_t units(Offset from, Offset to) const;
    [[nodiscard]] Offset size() const { return static_cast<Offset>(bytes_.size()); }

    std::string_view bytes_;
    Encoding encoding_;
    std::uint32_t line_count_ = 1;
    std::vector<Checkpoint> checkpoints_;
};

} // namespace maclint
