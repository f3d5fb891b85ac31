//! Source: bytes that stay in place, and a line index built when the first position is asked for.
#include "analyzer/source/source.hpp"

#include "analyzer/source/double_byte.hpp"
#include "analyzer/source/made_once.hpp"

#include <cassert>
#include <limits>
#include <optional>
#include <utility>

namespace maclint {

namespace {

Encoding encoding_of(std::string_view bytes) {
    const Encoding encoding = detect_encoding(bytes);
    return encoding == Encoding::utf8 ? encoding : detect_double_byte(bytes).value_or(encoding);
}

/// A character takes at most three bytes of UTF-8 for each of its own, and all have to be counted.
bool is_converted(Encoding encoding, std::size_t size) {
    constexpr std::size_t growth = 3;
    return (encoding == Encoding::shift_jis || encoding == Encoding::gbk) &&
           size < std::numeric_limits<Offset>::max() / growth;
}

} // namespace

/// Text of characters of one or two bytes is turned into UTF-8 at once: the second byte of a character is no
/// bracket to anybody then.
struct Source::Contents {
    Contents(std::string given_path, std::string given_bytes, std::optional<Encoding> given_encoding)
        : path(std::move(given_path))
        , stored_encoding(given_encoding ? *given_encoding : encoding_of(given_bytes))
        , converted(is_converted(stored_encoding, given_bytes.size()))
        , encoding(stored_encoding == Encoding::windows_1252 ? stored_encoding : Encoding::utf8)
        , bytes(converted ? maclint::to_utf8(given_bytes, stored_encoding) : std::move(given_bytes))
        , stored(converted ? std::move(given_bytes) : std::string()) {}

    const LineIndex& lines() const {
        return index.get([this] { return LineIndex(bytes, encoding); });
    }

    const std::string path;
    const Encoding stored_encoding;
    const bool converted;
    const Encoding encoding; ///< of `bytes`
    const std::string bytes;
    const std::string stored; ///< empty where `bytes` are those of the file
    mutable MadeOnce<LineIndex> index;
};

Source::Source(std::shared_ptr<const Contents> contents)
    : contents_(std::move(contents)) {}

Source Source::from_bytes(std::string path, std::string bytes) {
    assert(bytes.size() <= std::numeric_limits<Offset>::max());
    return Source(std::make_shared<const Contents>(std::move(path), std::move(bytes), std::nullopt));
}

Source Source::read_as(Encoding encoding) const {
    return Source(std::make_shared<const Contents>(contents_->path, std::string(stored_bytes()), encoding));
}

const std::string& Source::path() const { return contents_->path; }

std::string_view Source::bytes() const { return contents_->bytes; }

std::string_view Source::stored_bytes() const {
    return contents_->converted ? contents_->stored : contents_->bytes;
}

Encoding Source::stored_encoding() const { return contents_->stored_encoding; }

std::string_view Source::bytes(Span span) const {
    assert(span.begin <= span.end && span.end <= size());
    return bytes().substr(span.begin, span.length());
}

Offset Source::size() const { return static_cast<Offset>(contents_->bytes.size()); }

Encoding Source::encoding() const { return contents_->encoding; }

bool Source::has_byte_order_mark() const { return byte_order_mark_length(bytes()) != 0; }

Position Source::position(Offset offset) const { return contents_->lines().position(offset); }

std::uint32_t Source::line_count() const { return contents_->lines().line_count(); }

Span Source::line_span(std::uint32_t line) const { return contents_->lines().line_span(line); }

std::string_view Source::line_text(std::uint32_t line) const { return bytes(line_span(line)); }

Offset Source::offset_at(std::uint32_t line, std::uint32_t column) const {
    return contents_->lines().offset_at(line, column);
}

std::string Source::to_utf8(std::string_view slice) const { return maclint::to_utf8(slice, encoding()); }

} // namespace maclint
