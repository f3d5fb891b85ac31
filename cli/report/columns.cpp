//! Widths by ranges of Unicode, lines by blanks.
#include "cli/report/columns.hpp"

#include "analyzer/source/encoding.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace maclint::cli {
namespace {

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

constexpr bool is_ascii(char c) { return static_cast<unsigned char>(c) < 0x80; }

template<class Ranges>
bool in(const Ranges& ranges, char32_t character) {
    return std::ranges::any_of(
        ranges, [=](Range range) { return range.first <= character && character <= range.last; });
}

} // namespace

std::size_t columns_of(char32_t character) {
    if (character < combining.front().first) return 1;
    return in(combining, character) ? 0 : in(wide, character) ? 2 : 1;
}

std::size_t columns_of(std::string_view utf8) {
    std::size_t columns = 0;
    while (!utf8.empty()) {
        const auto ascii = static_cast<std::size_t>(std::ranges::find_if_not(utf8, is_ascii) - utf8.begin());
        columns += ascii;
        utf8.remove_prefix(ascii);
        if (utf8.empty()) break;
        const Character character = first_character(utf8);
        columns += columns_of(character.value);
        utf8.remove_prefix(character.length);
    }
    return columns;
}

std::vector<std::string> wrapped(std::string_view text, std::size_t first, std::size_t width) {
    std::vector<std::string> lines(1);
    std::size_t used = 0;
    while (!text.empty()) {
        const std::string_view word = text.substr(0, text.find(' '));
        text.remove_prefix(std::min(text.size(), word.size() + 1));
        if (word.empty()) continue;
        const std::size_t columns = columns_of(word);
        const std::size_t most = lines.size() == 1 ? first : width;
        if (used > 0 && used + 1 + columns > most) {
            lines.emplace_back();
            used = 0;
        }
        if (used > 0) lines.back() += ' ';
        lines.back() += word;
        used += columns + (used > 0 ? 1 : 0);
    }
    return lines;
}

} // namespace maclint::cli
