//! Look-ups of texts in hash maps without making a string first.
#pragma once

#include <cstddef>
#include <functional>
#include <string_view>

namespace maclint {

struct TextHash {
    using is_transparent = void; // NOLINT(readability-identifier-naming): the standard's name
    std::size_t operator()(std::string_view text) const { return std::hash<std::string_view>{}(text); }
};

} // namespace maclint
