//! Text into the bytes of an encoding.
#pragma once

#include "analyzer/source/encoding.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace maclint {

/// The valid UTF-8 in the encoding; nothing where a character is none of it. Of Shift-JIS and GBK only ASCII
/// is written.
[[nodiscard]] std::optional<std::string> encode(std::string_view utf8, Encoding encoding);

/// Bytes that a character takes in UTF-8.
[[nodiscard]] std::size_t utf8_length(char32_t character);

} // namespace maclint
