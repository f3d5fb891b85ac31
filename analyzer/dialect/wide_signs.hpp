//! Signs that look like those of the language but are others, as word processors and wide keyboards write
//! them.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace maclint {

struct WideSign {
    std::size_t length; ///< bytes that it takes in the text
    char meant;
};

/// The minus, plus, point or figure that the character at `at`, in UTF-8 or Windows-1252, was meant to be.
[[nodiscard]] std::optional<WideSign> wide_sign_at(std::string_view text, std::size_t at);

} // namespace maclint
