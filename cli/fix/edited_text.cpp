//! Offsets of findings are into the text in UTF-8; a file in Shift-JIS or GBK is walked through beside it.
#include "cli/fix/edited_text.hpp"

#include "analyzer/source/double_byte.hpp"

#include <algorithm>
#include <optional>
#include <string_view>

namespace maclint::cli {
namespace {

bool is_double_byte(Encoding encoding) {
    return encoding == Encoding::shift_jis || encoding == Encoding::gbk;
}

/// Bytes of a character in UTF-8.
std::size_t utf8_length(char32_t character) {
    if (character < 0x80) return 1;
    if (character < 0x800) return 2;
    return character < 0x10000 ? 3 : 4;
}

/// Where offsets, asked for from small to large, are in the stored file.
class StoredPlaces {
  public:
    explicit StoredPlaces(const Source& source)
        : stored_(source.stored_bytes())
        , encoding_(source.stored_encoding()) {}

    [[nodiscard]] std::size_t at(Offset offset) {
        if (!is_double_byte(encoding_)) return offset;
        while (read_ < offset && place_ < stored_.size()) {
            const Character next = double_byte_character(stored_.substr(place_), encoding_);
            place_ += next.length;
            read_ += utf8_length(next.value);
        }
        return place_;
    }

  private:
    std::string_view stored_;
    Encoding encoding_;
    std::size_t place_ = 0; ///< in the stored bytes
    std::size_t read_ = 0;  ///< bytes of UTF-8 before it
};

/// The byte of Windows-1252 that means the character.
std::optional<char> in_windows_1252(char32_t character) {
    constexpr int bytes = 256;
    for (int byte = 0; byte < bytes; ++byte) {
        const char one = static_cast<char>(byte);
        if (first_character(to_utf8({&one, 1}, Encoding::windows_1252)).value == character) return one;
    }
    return std::nullopt;
}

std::variant<std::string, NotEditable> encoded(std::string_view utf8, Encoding encoding) {
    if (encoding == Encoding::utf8) return std::string(utf8);
    std::string bytes;
    while (!utf8.empty()) {
        const Character next = first_character(utf8);
        const bool is_ascii = next.value < 0x80;
        const auto byte = is_ascii                             ? std::optional(static_cast<char>(next.value))
                          : encoding == Encoding::windows_1252 ? in_windows_1252(next.value)
                                                               : std::nullopt;
        if (!byte)
            return NotEditable{"'" + std::string(utf8.substr(0, next.length)) + "' cannot be written in " +
                               std::string(name_of(encoding))};
        bytes += *byte;
        utf8.remove_prefix(next.length);
    }
    return bytes;
}

std::string with_line_ends(std::string_view text, std::string_view line_end) {
    std::string result;
    for (const char c : text)
        if (c == '\n')
            result += line_end;
        else
            result += c;
    return result;
}

/// Of the file's first line.
std::string_view line_end_of(std::string_view text) {
    const auto end = text.find('\n');
    return end != std::string_view::npos && end > 0 && text[end - 1] == '\r' ? "\r\n" : "\n";
}

} // namespace

std::variant<std::string, NotEditable> edited_text(const Source& source, std::span<const Edit> edits) {
    const std::string_view stored = source.stored_bytes();
    const std::string_view line_end = line_end_of(stored);
    StoredPlaces places(source);
    std::string text;
    std::size_t copied = 0;
    for (const Edit& edit : edits) {
        const std::size_t begin = places.at(edit.span.begin);
        text += stored.substr(copied, begin - copied);
        auto bytes = encoded(with_line_ends(edit.text, line_end), source.stored_encoding());
        if (auto* refused = std::get_if<NotEditable>(&bytes)) return std::move(*refused);
        text += std::get<std::string>(bytes);
        copied = places.at(edit.span.end);
    }
    text += stored.substr(copied);
    return text;
}

} // namespace maclint::cli
