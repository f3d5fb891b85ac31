//! Encodings of one or two bytes a character, Shift-JIS and GBK, as controls and PCs of Japan and China
//! write.
#pragma once

#include "analyzer/source/encoding.hpp"

#include <array>
#include <optional>
#include <string_view>

namespace maclint {

/// The character that `bytes`, which are not empty, begin with, and how many of them it takes. What is none
/// is U+FFFD and takes one byte, so that a line end or bracket after it stays one.
[[nodiscard]] Character double_byte_character(std::string_view bytes, Encoding encoding);

/// Shift-JIS or GBK where the bytes leave no doubt: all of them fit, and they hold what hardly any text of
/// another encoding does, such as Japanese letters, or Chinese words of the workshop. Nothing for valid
/// UTF-8.
[[nodiscard]] std::optional<Encoding> detect_double_byte(std::string_view bytes);

/// By first byte: 81 to 9F and E0 to FC.
extern const std::array<std::u16string_view, 60> shift_jis_rows;
/// By first byte: 81 to FE.
extern const std::array<std::u16string_view, 126> gbk_rows;

} // namespace maclint
