//! A block as a dialect's splitter cuts it out of a file.
#pragma once

#include "analyzer/source/span.hpp"

#include <vector>

namespace maclint {

struct RawBlock {
    Span span;                  ///< without blanks around it
    Offset next;                ///< after its end of block
    std::vector<Span> comments; ///< brackets included
    bool open_comment;          ///< the last comment lacks its bracket
    Offset code;                ///< bytes that are neither blank nor comment
};

} // namespace maclint
