//! Byte offsets and half-open byte ranges: how everything in maclint says where it stands in a file.
#pragma once

#include <compare>
#include <cstdint>

namespace maclint {

/// A place in a file in bytes from its first; files of 4 GiB or more are refused when they are read.
using Offset = std::uint32_t;

/// The bytes from `begin` up to, not including, `end`.
struct Span {
    Offset begin = 0;
    Offset end = 0;

    [[nodiscard]] constexpr Offset length() const { return end - begin; }
    [[nodiscard]] constexpr bool empty() const { return begin == end; }
    /// Is the byte at `offset` one of these?
    [[nodiscard]] constexpr bool contains(Offset offset) const { return begin <= offset && offset < end; }
    /// Is every byte of `other` one of these?
    [[nodiscard]] constexpr bool covers(Span other) const { return begin <= other.begin && other.end <= end; }
    /// Do the two share a byte?
    [[nodiscard]] constexpr bool overlaps(Span other) const { return begin < other.end && other.begin < end; }

    /// In the order of the file: by begin, then by end.
    friend constexpr auto operator<=>(const Span&, const Span&) = default;
};

/// The smallest span that covers both.
[[nodiscard]] constexpr Span join(Span a, Span b) {
    return {a.begin < b.begin ? a.begin : b.begin, a.end > b.end ? a.end : b.end};
}

} // namespace maclint
