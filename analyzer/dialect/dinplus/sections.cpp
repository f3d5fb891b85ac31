//! Section words in whatever case and encoding they come.
#include "analyzer/dialect/dinplus/sections.hpp"

#include "analyzer/dialect/ascii.hpp"
#include "analyzer/dialect/characters.hpp"
#include "analyzer/source/encoding.hpp"

#include <algorithm>
#include <bitset>

namespace maclint::dinplus {
namespace {

constexpr bool is_blank(char c) { return c == ' ' || c == '\t'; }
constexpr bool is_ascii(char c) { return static_cast<unsigned char>(c) < 0x80; }

/// Asked before anything is copied: most lines of most texts begin like no section word.
bool may_begin_section(char c) {
    static const auto letters = [] {
        std::bitset<256> all;
        for (const SectionWord& row : section_words()) all.set(static_cast<unsigned char>(row.word.front()));
        return all;
    }();
    return !is_ascii(c) || letters[static_cast<unsigned char>(to_capital(c))];
}

} // namespace

std::string capitals_of(std::string_view words) {
    std::string capitals = in_capitals(words);
    if (std::ranges::all_of(capitals, is_ascii)) return capitals;
    capitals = to_utf8(capitals, detect_encoding(capitals));
    constexpr char latin = '\xC3'; // à to þ, and their capitals 32 places before them
    constexpr auto small = static_cast<unsigned char>(0xA0);
    constexpr auto last = static_cast<unsigned char>(0xBE);
    for (std::size_t i = 1; i < capitals.size(); ++i) {
        const auto byte = static_cast<unsigned char>(capitals[i]);
        if (capitals[i - 1] == latin && byte >= small && byte <= last)
            capitals[i] = static_cast<char>(byte - 0x20);
    }
    return capitals;
}

std::optional<FoundSection> find_section(std::string_view words) {
    if (words.empty() || !may_begin_section(words.front())) return std::nullopt;
    constexpr std::size_t most_words = 3;
    std::size_t ends[most_words] = {};
    std::size_t count = 0;
    for (std::size_t at = 0; at < words.size() && count < most_words;) {
        while (at < words.size() && !is_blank(words[at])) ++at;
        ends[count++] = at;
        while (at < words.size() && is_blank(words[at])) ++at;
    }
    for (; count > 0; --count) {
        const std::string_view name = words.substr(0, ends[count - 1]);
        const std::string capitals = capitals_of(name);
        const SectionWord* row = find_section_word(capitals);
        if (row == nullptr) continue;
        return FoundSection{row, static_cast<Offset>(name.size()), in_capitals(name) == name};
    }
    return std::nullopt;
}

const SectionKind& kind_of(const SectionWord& word) {
    return *std::ranges::find(control().sections, word.kind, &SectionKind::name);
}

std::string spelling_of(const SectionWord& word) {
    return std::string(word.use == SectionWord::Use::translated ? word.kind : word.word);
}

} // namespace maclint::dinplus
