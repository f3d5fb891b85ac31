//! Lays a line out column by column: a character may take no column, one, two, or several when it is escaped.
#include "cli/report/snippet.hpp"

#include "cli/report/columns.hpp"

#include <algorithm>
#include <utility>
#include <vector>

namespace maclint::cli {
namespace {

constexpr std::size_t tab_width = 4;
constexpr Offset most_bytes = 4; ///< of a character

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
    if (bytes.size() == 1 && bytes.front() >= ' ' && bytes.front() <= '~')
        return {std::string(bytes), 1, false}; // nearly all
    const std::string utf8 = source.to_utf8(bytes);
    std::string text = printable(utf8);
    if (text != utf8) return {text, text.size(), false}; // an escape, ASCII only
    const char32_t first = first_character(text).value;
    return {std::move(text), columns_of(first), false};
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

/// Where a line is cut.
Cell dots() { return {"…", 1, false}; }

std::size_t width_of(const std::vector<Cell>& cells) {
    std::size_t width = 0;
    for (const Cell& cell : cells) width += cell.width;
    return width;
}

/// Cuts what stands well before the marks, or the line's end when that is meant.
void cut_before(std::vector<Cell>& cells, std::size_t most) {
    const auto marked = std::ranges::find_if(cells, &Cell::marked);
    const std::size_t context = most / 3;
    std::size_t before = width_of({cells.begin(), marked});
    if (before <= context) return;
    auto keep = cells.begin();
    while (keep != marked && before + 1 > context) before -= (keep++)->width;
    cells.erase(cells.begin(), keep);
    cells.insert(cells.begin(), dots());
}

void cut_after(std::vector<Cell>& cells, std::size_t most) {
    if (width_of(cells) <= most) return;
    std::size_t kept = 0;
    cells.erase(std::ranges::find_if(cells, [&](const Cell& cell) { return (kept += cell.width) >= most; }),
                cells.end());
    cells.push_back(dots());
}

void drop_indent(std::vector<Cell>& cells) {
    const auto blank = [](const Cell& cell) {
        return !cell.marked && cell.text.find_first_not_of(' ') == std::string::npos;
    };
    cells.erase(cells.begin(), std::ranges::find_if_not(cells, blank));
}

/// The bytes of a line that may be seen in `columns`: a line can be as long as a file.
Span window_of(const Source& source, Span line, Span marked, Offset columns) {
    if (line.length() <= columns * most_bytes) return line;
    const auto at_character = [&](Offset at) {
        return static_cast<Offset>(character_begin(source.bytes(), at, source.encoding()));
    };
    Span window = line;
    if (marked.begin - line.begin > columns) window.begin = at_character(marked.begin - columns);
    if (line.end - marked.begin > columns * 2) window.end = at_character(marked.begin + columns * 2);
    return window;
}

/// Blanks up to the marked cells, and a caret for each column of theirs.
std::string marks_below(const std::vector<Cell>& cells) {
    std::string marks;
    std::string waiting; // blanks count only when a caret follows
    for (const Cell& cell : cells) {
        waiting.append(cell.width, cell.marked ? '^' : ' ');
        if (cell.marked) marks += std::exchange(waiting, "");
    }
    if (!marks.empty()) return marks;
    // The line begins with what takes no column, or its end is meant.
    return std::ranges::any_of(cells, &Cell::marked) ? "^" : waiting + "^";
}

} // namespace

CodeLine code_line(const Source& source, Span span, std::size_t width) {
    const Span line = source.line_span(source.position(span.begin).line);
    Span marked{std::clamp(span.begin, line.begin, line.end), std::min(span.end, line.end)};
    if (marked.end <= marked.begin) marked.end = std::min(marked.begin + 1, line.end);
    const Span window = window_of(source, line, marked, static_cast<Offset>(width));
    auto cells = cells_of(source, window, marked);
    if (window.begin > line.begin) cells.insert(cells.begin(), dots());
    drop_indent(cells);
    const bool at_end = marked.empty(); // its caret stands after the text
    if (at_end) width -= 1;
    if (width_of(cells) > width) cut_before(cells, width);
    cut_after(cells, width);
    CodeLine out{"", marks_below(cells)};
    for (const Cell& cell : cells) out.text += cell.text;
    while (out.text.ends_with(' ')) out.text.pop_back();
    return out;
}

} // namespace maclint::cli
