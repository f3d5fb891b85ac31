//! Character encodings of NC files, and how their text is made fit for a report or a terminal.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace maclint {

enum class Encoding : std::uint8_t { utf8, windows_1252, shift_jis, gbk };

/// As in a configuration: "utf-8", "shift-jis".
[[nodiscard]] std::string_view name_of(Encoding encoding);
/// As registered with IANA: "UTF-8", "Shift_JIS".
[[nodiscard]] std::string_view registered_name_of(Encoding encoding);

/// UTF-8 when every byte fits it, otherwise Windows-1252, in which every byte means something.
[[nodiscard]] Encoding detect_encoding(std::string_view bytes);

/// Length in bytes of the UTF-8 byte order mark that `bytes` begins with: 3 or 0.
[[nodiscard]] std::size_t byte_order_mark_length(std::string_view bytes);

/// The text as valid UTF-8, whatever the bytes are: a sequence cut or broken becomes U+FFFD.
[[nodiscard]] std::string to_utf8(std::string_view bytes, Encoding encoding);

/// A character and the bytes that it takes.
struct Character {
    char32_t value;
    std::size_t length;
};
/// The character that valid UTF-8, which is not empty, begins with.
[[nodiscard]] Character first_character(std::string_view utf8);

/// Length of the text in UTF-16 code units, the unit of columns in SARIF and LSP.
/// `bytes`, in UTF-8 or Windows-1252, begins and ends between characters.
[[nodiscard]] std::size_t utf16_length(std::string_view bytes, Encoding encoding);

/// The nearest offset at or before `offset` where a character begins.
[[nodiscard]] std::size_t character_begin(std::string_view bytes, std::size_t offset, Encoding encoding);

/// The text with everything a terminal would act on or a reader could not see written as an escape:
/// `\n`, `\x1B`, `\u{202E}`. Tabs stay. The result is valid UTF-8 even if the text is not.
[[nodiscard]] std::string printable(std::string_view utf8);

/// JSON text, valid UTF-8, with the same characters in its strings written as JSON has it: `\u009B`. It means
/// the same afterwards.
[[nodiscard]] std::string printable_json(std::string_view json);

} // namespace maclint
