//! Positions of the protocol against bytes of a text.
#pragma once

#include "analyzer/source/source.hpp"
#include "cli/lsp/protocol/json.hpp"

#include <memory>
#include <vector>

namespace maclint::cli::lsp {

/// What a column counts.
enum class PositionEncoding : std::uint8_t { utf16, utf8 };

/// The lines of a text as LSP counts them: each LF, CRLF and CR ends one, on tapes, too, where maclint takes
/// several for one.
class LineTable {
  public:
    LineTable(Source source, PositionEncoding encoding);

    [[nodiscard]] const Source& source() const { return source_; }
    [[nodiscard]] Json position(Offset offset) const;
    [[nodiscard]] Json range(Span span) const;
    /// A line after the last is the text's end, a column after a line's end that end.
    [[nodiscard]] Offset offset(const Json& position) const;
    [[nodiscard]] Span span(const Json& range) const;
    /// From 0.
    [[nodiscard]] std::size_t line_of(Offset offset) const;
    /// The line, from 0, without its end.
    [[nodiscard]] Span line(std::size_t number) const;

  private:
    [[nodiscard]] std::size_t column(Offset begin, Offset offset) const;

    Source source_;
    PositionEncoding encoding_;
    std::vector<Offset> begins_;
};

} // namespace maclint::cli::lsp
