//! Looks at letters only: when a report is written, nobody holds the program any more.
#include "cli/report/numberless.hpp"

#include "analyzer/source/encoding.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <span>

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

/// Words that a number of a block follows. P and Q mean much else, too.
constexpr std::array<std::string_view, 5> jump_words = {"GOTO", "NS", "NE", "P", "Q"};
constexpr std::size_t always_jumps = 3;
constexpr std::array<std::string_view, 6> takes_blocks = {"M97", "M99", "G70", "G71", "G72", "G73"};

std::span<const std::string_view> jump_words_of(std::string_view line) {
    const bool all =
        std::ranges::any_of(takes_blocks, [&](std::string_view word) { return has_word(line, word); });
    return std::span(jump_words).first(all ? jump_words.size() : always_jumps);
}

/// The number that follows one of the words at `at`, or stands there alone; empty: none.
std::string_view jump_number(std::string_view text, std::size_t at, std::span<const std::string_view> words) {
    if (at == 0 && digits_at(text, 0).size() == text.size()) return text;
    for (const std::string_view word : words) {
        if (!text.substr(at).starts_with(word)) continue;
        const std::string_view digits = digits_at(text, at + word.size());
        const std::size_t end = at + word.size() + digits.size();
        if (!digits.empty() && (end == text.size() || text[end] != '.')) return digits;
    }
    return {};
}

template<class IsBorne>
std::string without_jumps(std::string_view text, const IsBorne& is_borne,
                          std::span<const std::string_view> words) {
    std::string out;
    for (std::size_t at = 0; at < text.size();) {
        const std::string_view number = jump_number(text, at, words);
        if (number.empty() || !is_borne(plain_number(number))) {
            out += text[at++];
            continue;
        }
        const auto begin = static_cast<std::size_t>(number.data() - text.data());
        out.append(text, at, begin - at).append("@");
        at = begin + number.size();
    }
    return out;
}

std::string without_sequence_number(std::string text) {
    const std::string_view number = sequence_number(text);
    if (number.empty()) return text;
    const auto begin = static_cast<std::size_t>(number.data() - text.data()) - 1; // its N
    return text.erase(begin, number.size() + 1);
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
    const std::string whole = compact(source.to_utf8(source.bytes(line)));
    const auto words = jump_words_of(whole);
    const auto is_borne = [&](const std::string& number) {
        return numbers_at(source, line_number).contains(number);
    };
    const auto text = [&](std::string compacted) {
        return without_jumps(without_sequence_number(std::move(compacted)), is_borne, words);
    };
    return {text(whole), text(compact(source.to_utf8(source.bytes(part))))};
}

} // namespace maclint::cli
