//! A line of a program with the part that matters underlined.
#pragma once

#include "analyzer/source/source.hpp"

#include <string>

namespace maclint::cli {

/// One line as a terminal shows it: printable, without indent, tabs expanded, cut around the marked part.
struct CodeLine {
    std::string text;
    std::string marks; ///< blanks, then at least one caret below the marked part
};

/// The line in which `span` begins, in at most `width` columns. Its cost does not grow with the line.
[[nodiscard]] CodeLine code_line(const Source& source, Span span, std::size_t width);

} // namespace maclint::cli
