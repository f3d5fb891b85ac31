//! The pieces of a block's text without any structure: what is left to look at when the parser gives up.
#pragma once

#include "analyzer/source/span.hpp"

#include <cstdint>
#include <string_view>
#include <vector>

namespace maclint::dinplus {

struct Token {
    enum class Kind : std::uint8_t {
        letters,  ///< letters and underscores in a row: keywords, addresses, names
        number,   ///< digits and points
        variable, ///< `#l1`, `#_name`, `#`
        open,     ///< `(`
        close,    ///< `)`
        text,     ///< closed on its line
        unclosed_text,
        comment,
        sign,  ///< an operator or a comma
        other, ///< means nothing outside of texts and comments
    };
    Kind kind;
    Span span; ///< in the file
};

/// Cuts the block at `block` in `file`, at most the first 64 KiB of it.
[[nodiscard]] std::vector<Token> tokens_of(std::string_view file, Span block);

} // namespace maclint::dinplus
