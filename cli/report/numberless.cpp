//! Looks at letters only: when a report is written, nobody holds the program any more.
#include "cli/report/numberless.hpp"

#include "analyzer/source/encoding.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <span>
#include <vector>

namespace maclint::cli {
namespace {

constexpr Offset long_line = 4096;

bool is_digit(char c) { return c >= '0' && c <= '9'; }

std::string_view digits_at(std::string_view text, std::size_t at) {
    std::size_t end = at;
    while (end < text.size() && is_digit(text[end])) ++end;
    return text.substr(std::min(at, text.size()), end - at);
}

/// "0020" and "20" are one number.
std::string plain_number(std::string_view digits) {
    const auto first = digits.find_first_not_of('0');
    return first == std::string_view::npos ? "0" : std::string(digits.substr(first));
}

/// Without blanks and in capitals.
std::string compact(std::string_view utf8) {
    std::string out;
    for (const char c : utf8)
        if (c != ' ' && c != '\t') out += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    return out;
}

/// The sequence number that a compact line begins with, behind its skip marks; empty: none.
std::string_view sequence_number(std::string_view line) {
    std::size_t at = 0;
    while (at < line.size() && line[at] == '/') at += 1 + digits_at(line, at + 1).size();
    if (at >= line.size() || line[at] != 'N') return {};
    return digits_at(line, at + 1);
}

/// O and a number, a colon in its place, or the mark that ends a tape.
bool begins_program(std::string_view line) {
    if (line.starts_with('%')) return true;
    return line.size() > 1 && (line[0] == 'O' || line[0] == ':') && is_digit(line[1]);
}

bool has_word(std::string_view line, std::string_view word) {
    for (auto at = line.find(word); at != std::string_view::npos; at = line.find(word, at + 1)) {
        const std::size_t end = at + word.size();
        if (end == line.size() || (!is_digit(line[end]) && line[end] != '.')) return true;
    }
    return false;
}

using Words = std::span<const std::string_view>;

constexpr std::array<std::string_view, 1> always_jumps = {"GOTO"};
/// Words that mean blocks beside some codes, and much else elsewhere.
constexpr std::array<std::string_view, 2> cycle_blocks = {"P", "Q"};
constexpr std::array<std::string_view, 6> takes_blocks = {"M97", "M99", "G70", "G71", "G72", "G73"};
/// The first and the last block of a contour, which stand together. NE alone is a comparison, too.
constexpr std::array<std::string_view, 2> contour_blocks = {"NS", "NE"};

/// Where in a compact line a number stands, and what is left of it.
struct Renumbered {
    std::size_t begin, end;
    std::string_view mark;
};

/// Numbers that follow the words outside of brackets, where conditions and amounts stand.
void add_numbers_behind(Words words, std::string_view line, std::vector<Renumbered>& found) {
    std::size_t depth = 0;
    for (std::size_t at = 0; at < line.size(); ++at) {
        if (line[at] == '[') ++depth;
        if (line[at] == ']' && depth > 0) --depth;
        if (depth > 0) continue;
        for (const std::string_view word : words) {
            if (!line.substr(at).starts_with(word)) continue;
            const std::size_t begin = at + word.size();
            const std::size_t end = begin + digits_at(line, begin).size();
            if (end > begin && (end == line.size() || line[end] != '.')) found.push_back({begin, end, "@"});
        }
    }
}

/// Each of the words has a number.
bool has_all(Words words, std::string_view line) {
    return std::ranges::all_of(words, [&](const std::string_view& word) {
        std::vector<Renumbered> found;
        add_numbers_behind({&word, 1}, line, found);
        return !found.empty();
    });
}

/// The sequence number of the line, and those of blocks that it jumps to.
std::vector<Renumbered> renumbered_in(std::string_view line) {
    std::vector<Renumbered> found;
    if (const std::string_view number = sequence_number(line); !number.empty()) {
        const auto begin = static_cast<std::size_t>(number.data() - line.data());
        found.push_back({begin - 1, begin + number.size(), ""}); // with its N
    }
    add_numbers_behind(always_jumps, line, found);
    if (std::ranges::any_of(takes_blocks, [&](std::string_view word) { return has_word(line, word); }))
        add_numbers_behind(cycle_blocks, line, found);
    if (has_all(contour_blocks, line)) add_numbers_behind(contour_blocks, line, found);
    std::ranges::sort(found, {}, &Renumbered::begin);
    return found;
}

/// The line from `begin` to `end` without those numbers.
std::string without(const std::vector<Renumbered>& numbers, std::string_view line, std::size_t begin,
                    std::size_t end) {
    std::string out;
    for (const Renumbered& number : numbers) {
        if (number.end <= begin || number.begin >= end) continue;
        out.append(line.substr(begin, std::max(number.begin, begin) - begin)).append(number.mark);
        begin = std::min(number.end, end);
    }
    return out.append(line.substr(begin, end - begin));
}

} // namespace

Numberless::Numbers Numberless::read_numbers(const Source& source) {
    Numbers numbers;
    for (std::uint32_t line = 1; line <= source.line_count(); ++line) {
        constexpr std::size_t enough = 64;
        const std::string begin = compact(source.line_text(line).substr(0, enough));
        if (begins_program(begin)) {
            numbers.begins.push_back(line);
            numbers.borne.emplace_back();
        }
        if (const auto number = sequence_number(begin); !number.empty())
            numbers.borne.back().insert(plain_number(number));
    }
    return numbers;
}

const std::unordered_set<std::string>& Numberless::numbers_at(const Source& source, std::uint32_t line) {
    const auto [entry, is_new] = numbers_.try_emplace(&source);
    Numbers& numbers = entry->second;
    if (is_new) numbers = read_numbers(source);
    const auto program = std::ranges::upper_bound(numbers.begins, line) - numbers.begins.begin();
    return numbers.borne.at(static_cast<std::size_t>(program));
}

NumberlessPlace Numberless::of(const Source& source, Span span) {
    const std::uint32_t line_number = source.position(span.begin).line;
    Span line = source.line_span(line_number);
    if (line.length() > long_line)
        line = {std::max(line.begin, span.begin - std::min(span.begin, long_line / 2)),
                std::min(line.end, span.begin + std::min(source.size() - span.begin, long_line / 2))};
    const Span part{std::clamp(span.begin, line.begin, line.end), std::clamp(span.end, line.begin, line.end)};
    const auto compacted = [&](Offset begin, Offset end) {
        return compact(source.to_utf8(source.bytes({begin, end})));
    };
    const std::string before = compacted(line.begin, part.begin);
    const std::string before_end = before + compacted(part.begin, part.end);
    const std::string whole = before_end + compacted(part.end, line.end);
    auto numbers = renumbered_in(whole);
    std::erase_if(numbers, [&](const Renumbered& number) {
        if (number.mark.empty()) return false;
        const std::string_view digits =
            std::string_view(whole).substr(number.begin, number.end - number.begin);
        return !numbers_at(source, line_number).contains(plain_number(digits));
    });
    return {without(numbers, whole, 0, whole.size()),
            without(numbers, whole, before.size(), before_end.size())};
}

} // namespace maclint::cli
