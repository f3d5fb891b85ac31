//! Source: bytes that stay in place, and a line index built when the first position is asked for.
#include "analyzer/source/source.hpp"

#include "analyzer/source/made_once.hpp"

#include <cassert>
#include <limits>
#include <optional>
#include <utility>

namespace maclint {

struct Source::Contents {
    Contents(std::string given_path, std::string given_bytes, std::optional<Encoding> given_encoding)
        : path(std::move(given_path))
        , bytes(std::move(given_bytes))
        , encoding(given_encoding ? *given_encoding : detect_encoding(bytes)) {}

    const LineIndex& lines() const {
        return index.get([this] { return LineIndex(bytes, encoding); });
    }

    const std::string path;
    const std::string bytes;
    const Encoding encoding;
    mutable MadeOnce<LineIndex> index;
};

Source::Source(std::shared_ptr<const Contents> contents)
    : contents_(std::move(contents)) {}

Source Source::from_bytes(std::string path, std::string bytes) {
    assert(bytes.size() <= std::numeric_limits<Offset>::max());
    return Source(std::make_shared<const Contents>(std::move(path), std::move(bytes), std::nullopt));
}

Source Source::read_as(Encoding encoding) const {
    return Source(std::make_shared<const Contents>(contents_->path, contents_->bytes, encoding));
}

const std::string& Source::path() const { return contents_->path; }

std::string_view Source::bytes() const { return contents_->bytes; }

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
