//! Offsets of findings are into the text in UTF-8; a file in Shift-JIS or GBK is walked through beside it.
#include "cli/fix/edited_text.hpp"

#include "analyzer/source/double_byte.hpp"
#include "analyzer/source/encode.hpp"
#include "analyzer/source/line_index.hpp"

#include <string_view>

namespace maclint::cli {
namespace {

bool is_double_byte(Encoding encoding) {
    return encoding == Encoding::shift_jis || encoding == Encoding::gbk;
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
    const std::size_t end = find_line_end(text, 0);
    if (end == text.size()) return "\n";
    return text.substr(end, after_line_end(text, static_cast<Offset>(end)) - end);
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
        const auto bytes = encode(with_line_ends(edit.text, line_end), source.stored_encoding());
        if (!bytes)
            return NotEditable{"'" + edit.text + "' cannot be written in " +
                               std::string(name_of(source.stored_encoding()))};
        text += *bytes;
        copied = places.at(edit.span.end);
    }
    text += stored.substr(copied);
    return text;
}

} // namespace maclint::cli
