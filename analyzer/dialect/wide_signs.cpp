//! A table of characters.
#include "analyzer/dialect/wide_signs.hpp"

#include <algorithm>
#include <iterator>

namespace maclint {
namespace {

struct Row {
    std::string_view written;
    char meant;
};

// clang-format off
constexpr Row rows[] = {
    {"\xE2\x80\x90", '-'}, // hyphen
    {"\xE2\x80\x91", '-'}, // hyphen that does not break
    {"\xE2\x80\x92", '-'}, // figure dash
    {"\xE2\x80\x93", '-'}, // en dash
    {"\xE2\x80\x94", '-'}, // em dash
    {"\xE2\x80\x95", '-'}, // horizontal bar
    {"\xE2\x88\x92", '-'}, // minus
    {"\xE3\x83\xBC", '-'}, // long vowel of Japanese
    {"\xEF\xBC\x8D", '-'}, // wide hyphen
    {"\xEF\xBD\xB0", '-'}, // long vowel of half width
    {"\xEF\xBC\x8B", '+'}, // wide plus
    {"\xEF\xBC\x8E", '.'}, // wide full stop
    {"\xE3\x80\x82", '.'}, // full stop of Chinese
    {"\x96", '-'}, // en dash of Windows-1252
    {"\x97", '-'}, // em dash of Windows-1252
};
// clang-format on

constexpr std::string_view before_figure = "\xEF\xBC"; // U+FF10 to U+FF19

constexpr bool is_ascii(char c) { return static_cast<unsigned char>(c) < 0x80; }

} // namespace

std::optional<WideSign> wide_sign_at(std::string_view text, std::size_t at) {
    if (at >= text.size() || is_ascii(text[at]) || (at > 0 && !is_ascii(text[at - 1]))) return std::nullopt;
    const std::string_view rest = text.substr(at);
    const auto* const row =
        std::ranges::find_if(rows, [&](const Row& candidate) { return rest.starts_with(candidate.written); });
    if (row != std::end(rows)) return WideSign{row->written.size(), row->meant};
    constexpr unsigned char zero = 0x90;
    if (!rest.starts_with(before_figure) || rest.size() <= before_figure.size()) return std::nullopt;
    const auto figure = static_cast<unsigned char>(rest[before_figure.size()]);
    if (figure < zero || figure > zero + 9) return std::nullopt;
    return WideSign{before_figure.size() + 1, static_cast<char>('0' + (figure - zero))};
}

} // namespace maclint
