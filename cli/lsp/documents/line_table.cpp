//! Columns are counted by the source's own index, so that long lines cost no more than short ones.
#include "cli/lsp/documents/line_table.hpp"

#include <algorithm>
#include <utility>

namespace maclint::cli::lsp {
namespace {

/// Each byte is a column, and looking at them costs less than asking the index.
bool is_short_ascii(std::string_view text) {
    constexpr std::size_t is_short = 256; // bytes
    return text.size() <= is_short &&
           std::ranges::all_of(text, [](char c) { return static_cast<unsigned char>(c) < 0x80; });
}

} // namespace

LineTable::LineTable(Source source, PositionEncoding encoding)
    : source_(std::move(source))
    , encoding_(encoding) {
    const std::string_view text = source_.bytes();
    begins_.push_back(static_cast<Offset>(byte_order_mark_length(text)));
    for (std::size_t at = find_line_end(text, 0); at < text.size(); at = find_line_end(text, at)) {
        at += text[at] == '\r' && at + 1 < text.size() && text[at + 1] == '\n' ? 2 : 1;
        begins_.push_back(static_cast<Offset>(at));
    }
}

std::size_t LineTable::line_of(Offset offset) const {
    const auto after = std::ranges::upper_bound(begins_, offset);
    return after == begins_.begin() ? 0 : static_cast<std::size_t>(after - begins_.begin()) - 1;
}

Span LineTable::line(std::size_t number) const {
    const Offset begin = begins_[std::min(number, begins_.size() - 1)];
    return {begin, static_cast<Offset>(find_line_end(source_.bytes(), begin))};
}

std::size_t LineTable::column(Offset begin, Offset offset) const {
    const Span part{begin, std::max(begin, offset)};
    if (is_short_ascii(source_.bytes(part))) return part.length();
    if (encoding_ == PositionEncoding::utf16)
        return source_.position(part.end).column - source_.position(begin).column;
    return source_.encoding() == Encoding::utf8 ? part.length() : source_.to_utf8(source_.bytes(part)).size();
}

Json LineTable::position(Offset offset) const {
    const std::size_t number = line_of(offset);
    const Span whole = line(number);
    return {{"line", number}, {"character", column(whole.begin, std::min(offset, whole.end))}};
}

Json LineTable::range(Span span) const {
    return {{"start", position(span.begin)}, {"end", position(span.end)}};
}

Offset LineTable::offset(const Json& position) const {
    const std::int64_t number = integer_in(position, "line"), character = integer_in(position, "character");
    if (number < 0 || character < 0)
        throw ResponseError{ErrorCode::invalid_params, "A position is negative. Count from 0."};
    if (static_cast<std::size_t>(number) >= begins_.size()) return source_.size();
    const Span whole = line(static_cast<std::size_t>(number));
    const auto wanted = static_cast<std::size_t>(character);
    if (encoding_ == PositionEncoding::utf16) {
        if (wanted >= whole.length()) return whole.end; // no character takes more units than bytes
        const Position begin = source_.position(whole.begin);
        const Offset found = source_.offset_at(begin.line, begin.column + static_cast<std::uint32_t>(wanted));
        return std::clamp(found, whole.begin, whole.end);
    }
    // Windows-1252 takes a byte where UTF-8 takes up to three.
    Offset at = whole.begin;
    if (source_.encoding() == Encoding::utf8)
        at = static_cast<Offset>(character_begin(
            source_.bytes(), std::min<std::size_t>(whole.begin + wanted, whole.end), Encoding::utf8));
    else
        while (at < whole.end && column(whole.begin, at + 1) <= wanted) ++at;
    return std::max(at, whole.begin);
}

Span LineTable::span(const Json& range) const {
    const Offset begin = offset(member(range, "start")), end = offset(member(range, "end"));
    return {begin, std::max(begin, end)};
}

} // namespace maclint::cli::lsp
