//! Tells NC text from what merely bears its file extension.
#pragma once

#include <cstdint>
#include <string_view>

namespace maclint {

enum class Content : std::uint8_t {
    empty,  ///< no character but blanks, line ends and tape leader
    text,   ///< to be linted
    utf16,  ///< text in an encoding that no control reads
    binary, ///< an image, an archive, line noise
};

/// Judges by the first 64 KiB. NULs are tape leader at the head and at the tail, and binary elsewhere.
[[nodiscard]] Content classify(std::string_view bytes);

/// Whether the bytes are Content::empty.
[[nodiscard]] bool is_empty(std::string_view bytes);

/// The bytes without the end-of-file marks (SUB, 1A) of CP/M and DOS at their end, alone or many, and the
/// blank lines and NULs that fill up a block of a disk after them. A mark with text after it stays.
[[nodiscard]] std::string_view without_end_of_file(std::string_view bytes);

} // namespace maclint
