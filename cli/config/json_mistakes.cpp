//! Looks at the characters around the place that a parser of JSON complains of.
#include "cli/config/json_mistakes.hpp"

#include <algorithm>
#include <cctype>
#include <cstddef>

namespace maclint::cli {
namespace {

constexpr std::string_view blanks = " \t\r\n";
constexpr std::size_t longest_shown = 60; ///< bytes of a text that is quoted

bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-'; }

/// The end of a comment that begins here; `at` where none does.
std::size_t after_comment(std::string_view text, std::size_t at) {
    const std::string_view rest = text.substr(at);
    if (rest.starts_with("//")) return std::min(text.find('\n', at), text.size());
    if (!rest.starts_with("/*")) return at;
    const std::size_t end = text.find("*/", at + 2);
    return end == std::string_view::npos ? text.size() : end + 2;
}

/// Behind the text in double quotes that begins here.
std::size_t after_text(std::string_view text, std::size_t at) {
    for (++at; at < text.size() && text[at] != '"'; ++at)
        if (text[at] == '\\') ++at;
    return std::min(at + 1, text.size());
}

/// The next character that is neither blank nor part of a comment.
std::size_t next_token(std::string_view text, std::size_t at) {
    while (at < text.size()) {
        const std::size_t behind = after_comment(text, at);
        if (behind == at && blanks.find(text[at]) == std::string_view::npos) break;
        at = std::max(behind, at + 1);
    }
    return at;
}

/// The word, or the text in single quotes, around a place; empty where there is none.
std::string_view word_at(std::string_view text, std::size_t at) {
    if (at >= text.size()) return {};
    if (text[at] == '\'') {
        const std::string_view inside = text.substr(at + 1);
        const std::size_t end = std::min(inside.find_first_of("'\n"), inside.size());
        return inside.substr(0, std::min(end, longest_shown));
    }
    std::size_t begin = at, end = at;
    while (begin > 0 && is_word(text[begin - 1])) --begin;
    while (end < text.size() && is_word(text[end])) ++end;
    return text.substr(begin, std::min(end - begin, longest_shown));
}

} // namespace

std::string without_trailing_commas(std::string_view text) {
    std::string out(text);
    for (std::size_t at = 0; at < text.size();) {
        if (text[at] == '"') {
            at = after_text(text, at);
        } else if (const std::size_t behind = after_comment(text, at); behind != at) {
            at = behind;
        } else {
            const std::size_t next = text[at] == ',' ? next_token(text, at + 1) : text.size();
            if (next < text.size() && (text[next] == '}' || text[next] == ']')) out[at] = ' ';
            ++at;
        }
    }
    return out;
}

JsonError mistake_at(std::string_view text, Offset at, std::string_view reason) {
    const auto says = [reason](std::string_view part) { return reason.find(part) != std::string_view::npos; };
    if (says("after backslash"))
        return {at, "a backslash stands for nothing here",
                "Write '/' between folders, on Windows, too, and \\\\ for a backslash itself"};
    const char here = at < text.size() ? text[at] : ' ';
    if (says("invalid literal") && here == '\'')
        return {at, "texts stand in double quotes", "Write \" in place of '"};
    if (says("invalid literal") && !word_at(text, at).empty())
        return {at, "a word has no quotes", "Write it in \" \""}; // not which: the file may be none of ours
    // "while parsing object - unexpected string literal; expected '}'"
    const bool is_in_list = says("while parsing object -") || says("while parsing array -");
    if (is_in_list && (says("unexpected string") || says("unexpected number") || says("unexpected '[") ||
                       says("unexpected '{")))
        return {at, "a comma is missing before this", "Put one behind what stands before it"};
    if (says("unexpected end of input"))
        return {at, "the file ends too early", "Close the brackets { } and [ ] that are still open"};
    const auto end =
        reason.find("; "); // "…: syntax error while parsing value - invalid literal; last read: …"
    const auto dash = reason.rfind(" - ", end);
    const bool is_known = dash != std::string_view::npos && end != std::string_view::npos;
    return {at,
            "this is no JSON: " +
                std::string(is_known ? reason.substr(dash + 3, end - dash - 3) : "syntax error"),
            "Correct it"};
}

} // namespace maclint::cli
