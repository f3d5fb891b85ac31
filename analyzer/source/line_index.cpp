//! The sparse line index: one pass that leaves a checkpoint every KiB, or more in a short text, and counting
//! from the nearest one.
#include "analyzer/source/line_index.hpp"

#include <algorithm>
#include <cstring>
#include <iterator>

namespace maclint {
namespace {

constexpr Offset farthest_checkpoints = 1024;
constexpr Offset nearest_checkpoints = 64;
/// So many fit into the memory that a short text takes anyway.
constexpr Offset usual_checkpoints = 256;

/// Whether one of eight bytes is `c`: a byte that is 0 borrows from the bit above it.
constexpr bool holds(std::uint64_t eight, char c) {
    constexpr std::uint64_t ones = 0x0101010101010101U;
    const std::uint64_t difference = eight ^ (ones * static_cast<unsigned char>(c));
    return ((difference - ones) & ~difference & (ones << 7U)) != 0;
}

} // namespace

Offset after_line_end(std::string_view bytes, Offset offset) {
    const auto is_at = [bytes](Offset at, char c) { return at < bytes.size() && bytes[at] == c; };
    if (bytes[offset] == '\r') return is_at(offset + 1, '\n') ? offset + 2 : offset + 1;
    if (!is_at(offset + 1, '\r')) return offset + 1;
    return is_at(offset + 2, '\r') ? offset + 3 : offset + 2;
}

LineIndex::LineIndex(std::string_view bytes, Encoding encoding)
    : bytes_(bytes)
    , encoding_(encoding) {
    build();
}

void LineIndex::build() {
    const auto text_begin = static_cast<Offset>(byte_order_mark_length(bytes_));
    const Offset distance = std::clamp(size() / usual_checkpoints, nearest_checkpoints, farthest_checkpoints);
    checkpoints_.reserve(size() / distance + 1);
    checkpoints_.push_back({text_begin, text_begin, 1, 0});
    std::uint64_t next = text_begin + std::uint64_t{distance};
    for (Checkpoint line = checkpoints_.front();;) {
        const Offset end = find_line_end(line.at, size());
        for (; next <= end; next += distance) {
            const auto at = static_cast<Offset>(character_begin(bytes_, next, encoding_));
            if (at <= line.at) continue;
            line.units += units(line.at, at);
            line.at = at;
            checkpoints_.push_back(line);
        }
        if (end == size()) {
            line_count_ = line.line;
            return;
        }
        const Offset begin = after_line_end(bytes_, end);
        line = {begin, begin, line.line + 1, 0};
        if (next <= begin) {
            checkpoints_.push_back(line);
            next = begin + std::uint64_t{distance};
        }
    }
}

Position LineIndex::position(Offset offset) const {
    offset = std::clamp(offset, checkpoints_.front().at, size());
    const auto after = std::upper_bound(checkpoints_.begin(), checkpoints_.end(), offset,
                                        [](Offset wanted, const Checkpoint& c) { return wanted < c.at; });
    Checkpoint from = *std::prev(after);
    while (true) {
        const Offset end = find_line_end(from.at, offset);
        if (end == offset) break;
        const Offset begin = after_line_end(bytes_, end);
        if (begin > offset) break;
        from = {begin, begin, from.line + 1, 0};
    }
    const auto character = static_cast<Offset>(character_begin(bytes_, offset, encoding_));
    const std::uint32_t before = character > from.at ? units(from.at, character) : 0;
    return {from.line, from.units + before + 1, offset - from.line_begin + 1};
}

Span LineIndex::line_span(std::uint32_t line) const {
    line = std::clamp(line, std::uint32_t{1}, line_count_);
    const auto after =
        std::upper_bound(checkpoints_.begin(), checkpoints_.end(), line,
                         [](std::uint32_t wanted, const Checkpoint& c) { return wanted < c.line; });
    Checkpoint from = *std::prev(after);
    while (from.line < line) {
        const Offset begin = after_line_end(bytes_, find_line_end(from.at, size()));
        from = {begin, begin, from.line + 1, 0};
    }
    return {from.line_begin, find_line_end(from.at, size())};
}

Offset LineIndex::offset_at(std::uint32_t line, std::uint32_t column) const {
    const Span span = line_span(line);
    std::uint32_t wanted = column > 0 ? column - 1 : 0;
    Offset at = span.begin;
    while (at < span.end) {
        Offset next = at + 1;
        while (next < span.end && character_begin(bytes_, next, encoding_) != next) ++next;
        const std::uint32_t width = units(at, next);
        if (wanted < width) return at;
        wanted -= width;
        at = next;
    }
    return span.end;
}

Offset LineIndex::find_line_end(Offset from, Offset to) const {
    for (; from + sizeof(std::uint64_t) <= to; from += sizeof(std::uint64_t)) {
        std::uint64_t eight = 0;
        std::memcpy(&eight, bytes_.data() + from, sizeof eight);
        if (holds(eight, '\n') || holds(eight, '\r')) break;
    }
    while (from < to && !is_line_end(bytes_[from])) ++from;
    return from;
}

std::uint32_t LineIndex::units(Offset from, Offset to) const {
    return static_cast<std::uint32_t>(utf16_length(bytes_.substr(from, to - from), encoding_));
}

} // namespace maclint
