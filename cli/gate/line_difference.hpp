//! Which lines of a text differ from an older one.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

namespace maclint::cli {

/// Lines of one text as git counts them, by line feeds: first and last, from 1.
struct LineRange {
    std::uint32_t first, last;

    friend bool operator==(const LineRange&, const LineRange&) = default;
};

/// The first line of a text, which a line feed ends. A carriage return before that belongs to the line's end.
struct FirstLine {
    explicit FirstLine(std::string_view text);

    std::string_view words; ///< without its end
    std::size_t size;       ///< bytes with its end
};

/// Lines [before, before_end) of one text that stand as [after, after_end) in the other; counted from 0.
struct LineDifference {
    std::uint32_t before, before_end, after, after_end;
};

/// What differs, in order. Where so much does that a bound of work is met, lines that did not change may be
/// among it. Texts of less than 4 GiB.
[[nodiscard]] std::vector<LineDifference> differences(std::string_view before, std::string_view after);

/// Lines that were added or changed, and those on both sides of what was taken out, in order. Bounded as
/// `differences`.
[[nodiscard]] std::vector<LineRange> changed_lines(std::string_view before, std::string_view after);

} // namespace maclint::cli
