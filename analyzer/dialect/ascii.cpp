//! Capitals, edit distance, names of files.
#include "analyzer/dialect/ascii.hpp"

#include "analyzer/dialect/characters.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>

namespace maclint {

std::string in_capitals(std::string_view text) {
    std::string capitals(text);
    for (char& c : capitals) c = to_capital(c);
    return capitals;
}

std::string without_blanks(std::string_view text) {
    std::string rest;
    bool quoted = false;
    for (const char c : text) {
        const bool is_blank = c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '\0';
        if (c == '"') quoted = !quoted;
        if (quoted || !is_blank) rest += quoted ? c : to_capital(c);
    }
    return rest;
}

namespace {

/// A bit for each letter that the word has.
std::uint32_t letters_in(std::string_view word) {
    std::uint32_t letters = 0;
    for (const char c : word) letters |= 1U << (static_cast<unsigned char>(c) & 31U);
    return letters;
}

} // namespace

std::size_t edit_distance(std::string_view a, std::string_view b, std::size_t most) {
    constexpr std::size_t longest = 16;
    if (a.size() > longest || b.size() > longest) return most + 1;
    const std::size_t longer = std::max(a.size(), b.size()) - std::min(a.size(), b.size());
    // An edit brings in one letter at most and takes out one.
    const auto others = static_cast<std::size_t>(std::popcount(letters_in(a) ^ letters_in(b)));
    if (longer > most || others > 2 * most) return most + 1;
    std::array<std::array<std::uint8_t, longest + 1>, longest + 1>
        cost{}; // small: noise asks a million times
    for (std::size_t i = 0; i <= longest; ++i) cost[i][0] = cost[0][i] = static_cast<std::uint8_t>(i);
    for (std::size_t i = 1; i <= a.size(); ++i)
        for (std::size_t j = 1; j <= b.size(); ++j) {
            int least = std::min(cost[i - 1][j], cost[i][j - 1]) + 1;
            least = std::min(least, cost[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1));
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                least = std::min(least, cost[i - 2][j - 2] + 1);
            cost[i][j] = static_cast<std::uint8_t>(least);
        }
    return std::min<std::size_t>(cost[a.size()][b.size()], most + 1);
}

bool addresses_maclint(std::string_view comment) {
    constexpr std::string_view name = "maclint";
    for (std::size_t at = 0; at + name.size() <= comment.size(); ++at) {
        std::size_t same = 0;
        while (same < name.size() && (comment[at + same] | 0x20) == name[same]) ++same;
        if (same == name.size()) return true;
    }
    return false;
}

void take_out_comments(std::string_view text, Span block, std::span<const Span> comments, std::string& rest) {
    rest.clear();
    Offset at = block.begin;
    const auto take = [&](Offset end) {
        for (; at < end; ++at)
            if (text[at] != ' ' && text[at] != '\t' && text[at] != '\0') rest += text[at];
    };
    for (const Span comment : comments) {
        take(comment.begin);
        at = comment.end;
    }
    take(block.end);
}

std::string_view file_name_of(std::string_view path) { return path.substr(path.rfind('/') + 1); }

std::string stem_of(std::string_view path) {
    std::string_view name = file_name_of(path);
    const std::size_t dot = name.rfind('.');
    if (dot != std::string_view::npos && dot != 0) name = name.substr(0, dot);
    return std::string(name);
}

} // namespace maclint
