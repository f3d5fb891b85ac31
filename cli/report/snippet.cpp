//! Lays a line out column by column: a character may take no column, one, two, or several when it is escaped.
#include "cli/report/snippet.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace maclint::cli {
namespace {

constexpr std::size_t tab_width = 4;
constexpr std::size_t widest = 110;        ///< columns of a line that are shown
constexpr std::size_t context = 30;        ///< columns shown before the marks of a line that is cut
constexpr std::uint32_t most_lines = 4;    ///< of a span that covers several
constexpr Offset longest_line = 64 * 1024; ///< bytes of a line that are looked at around the span

struct Range {
    char32_t first, last;
};

/// Characters two columns wide (Unicode 15, East_Asian_Width W and F, blocks rounded).
constexpr std::array wide{Range{0x1100, 0x115F},   Range{0x2E80, 0x303E},   Range{0x3041, 0x33FF},
                          Range{0x3400, 0x4DBF},   Range{0x4E00, 0x9FFF},   Range{0xA000, 0xA4CF},
                          Range{0xA960, 0xA97F},   Range{0xAC00, 0xD7A3},   Range{0xF900, 0xFAFF},
                          Range{0xFE30, 0xFE6F},   Range{0xFF00, 0xFF60},   Range{0xFFE0, 0xFFE6},
                          Range{0x1F300, 0x1F64F}, Range{0x1F900, 0x1F9FF}, Range{0x20000, 0x3FFFD}};

/// Characters that sit on the one before (Unicode 15, general category Mn, the common blocks).
constexpr std::array combining{Range{0x0300, 0x036F}, Range{0x1AB0, 0x1AFF}, Range{0x1DC0, 0x1DFF},
                               Range{0x20D0, 0x20FF}, Range{0xFE00, 0xFE0F}, Range{0xFE20, 0xFE2F}};

template<class Ranges>
bool in(const Ranges& ranges, char32_t character) {
    return std::ranges::any_of(
        ranges, [=](Range range) { return range.first <= character && character <= range.last; });
}

/// One character of the line as it is shown.
struct Cell {
    std::string text;
    std::size_t width;
    bool marked;
};

Cell cell_of(const Source& source, Span character, std::size_t column) {
    const std::string_view bytes = source.bytes(character);
    if (bytes == "\t") {
        const std::size_t width = tab_width - column % tab_width;
        return {std::string(width, ' '), width, false};
    }
    const std::string utf8 = source.to_utf8(bytes);
    std::string text = printable(utf8);
    if (text != utf8) return {text, text.size(), false}; // an escape, ASCII only
    const char32_t first = first_character(text).value;
    return {std::move(text), in(combining, first) ? 0U : in(wide, first) ? 2U : 1U, false};
}

Offset next_character(const Source& source, Offset at, Offset end) {
    Offset next = at + 1;
    if (source.encoding() == Encoding::windows_1252) return next;
    while (next < end && next - at < 4 && (static_cast<unsigned char>(source.bytes()[next]) & 0xC0U) == 0x80U)
        ++next;
    return next;
}

/// What takes no column of its own is seen on the character that it sits on.
void mark_carrier(std::vector<Cell>& cells) {
    const auto carrier = std::ranges::find_if(cells.rbegin(), cells.rend(), &Cell::width);
    if (carrier != cells.rend()) carrier->marked = true;
}

std::vector<Cell> cells_of(const Source& source, Span line, Span marked) {
    std::vector<Cell> cells;
    std::size_t column = 0;
    for (Offset at = line.begin; at < line.end;) {
        const Offset next = next_character(source, at, line.end);
        Cell cell = cell_of(source, {at, next}, column);
        cell.marked = marked.overlaps({at, next});
        if (cell.marked && cell.width == 0) mark_carrier(cells);
        column += cell.width;
        cells.push_back(std::move(cell));
        at = next;
    }
    return cells;
}

/// The part of a long line around its marks, "…" where it is cut.
void cut(std::vector<Cell>& cells) {
    std::size_t width = 0;
    std::size_t before = 0;
    bool seen = false;
    for (const Cell& cell : cells) {
        seen = seen || cell.marked;
        if (!seen) before += cell.width;
        width += cell.width;
    }
    if (width <= widest) return;
    const Cell dots{"…", 1, false};
    if (seen && before > context) {
        std::size_t dropped = 0;
        auto keep = cells.begin();
        while (keep != cells.end() && dropped + keep->width <= before - context) dropped += (keep++)->width;
        cells.erase(cells.begin(), keep);
        cells.insert(cells.begin(), dots);
    }
    std::size_t kept = 0;
    const auto end =
        std::ranges::find_if(cells, [&](const Cell& cell) { return (kept += cell.width) > widest; });
    if (end == cells.end()) return;
    cells.erase(end, cells.end());
    cells.push_back(dots);
}

FrameLine layout(const Source& source, std::uint32_t number, Span marked) {
    Span line = source.line_span(number);
    if (line.length() > longest_line) {
        // Cut between characters, well before what is shown.
        const Offset near = std::clamp(marked.begin, line.begin, line.end);
        const Offset from = near - line.begin > longest_line / 2 ? near - longest_line / 2 : line.begin;
        line.begin = static_cast<Offset>(character_begin(source.bytes(), from, source.encoding()));
        line.end = static_cast<Offset>(character_begin(
            source.bytes(), std::min(line.end, line.begin + longest_line), source.encoding()));
    }
    auto cells = cells_of(source, line, marked);
    cut(cells);
    FrameLine out{number, "", ""};
    const bool any = std::ranges::any_of(cells, &Cell::marked);
    std::string waiting; // blanks count only when a caret follows
    for (const Cell& cell : cells) {
        out.text += cell.text;
        waiting.append(cell.width, cell.marked ? '^' : ' ');
        if (cell.marked) out.marks += std::exchange(waiting, "");
    }
    if (any && out.marks.empty()) out.marks = "^"; // the line begins with what takes no column
    if (out.marks.empty() && marked.begin >= line.end) out.marks = waiting + "^"; // at the line's end
    if (out.marks.empty() && marked.empty()) {
        const Offset at = std::max(marked.begin, line.begin);
        out.marks = layout(source, number, {at, at + 1}).marks;
    }
    while (out.text.ends_with(' ')) out.text.pop_back();
    return out;
}

/// From the first character that is no blank: carets below an indent say nothing.
Span without_indent(const Source& source, Span part) {
    const std::string_view bytes = source.bytes();
    while (part.begin < part.end && (bytes[part.begin] == ' ' || bytes[part.begin] == '\t')) ++part.begin;
    return part;
}

} // namespace

std::vector<FrameLine> frame_of(const Source& source, Span span) {
    const std::uint32_t first = source.position(span.begin).line;
    const std::uint32_t last = span.empty() ? first : source.position(span.end - 1).line;
    std::vector<FrameLine> lines;
    for (std::uint32_t number = first; number <= last; ++number) {
        const bool skip = last - first >= most_lines && number >= first + 2 && number < last;
        if (skip) {
            lines.push_back({0, "…", ""});
            number = last - 1;
            continue;
        }
        const Span line = source.line_span(number);
        const Span part{std::max(span.begin, line.begin), std::min(span.end, line.end)};
        lines.push_back(layout(
            source, number, number == first || part.begin >= part.end ? part : without_indent(source, part)));
    }
    return lines;
}

} // namespace maclint::cli
