//! Text of a block as an error about it shows it.
#pragma once

#include "analyzer/program/syntax_error.hpp"

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>

namespace maclint {

inline constexpr std::size_t longest_shown = 60;

/// The text, or its beginning where it is long.
[[nodiscard]] inline std::string shown(std::string_view text) {
    if (text.size() <= longest_shown) return std::string(text);
    return std::string(text.substr(0, longest_shown)) + "...";
}

/// What the parser cannot read, where nothing tells why.
[[nodiscard]] inline SyntaxError unreadable(std::string_view text, Span span, std::string expected) {
    return {SyntaxErrorKind::unreadable, span, shown(text.substr(span.begin, span.length())),
            std::move(expected)};
}

} // namespace maclint
