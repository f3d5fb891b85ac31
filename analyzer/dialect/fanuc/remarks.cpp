//! Searches remarks for the call of a program, and texts for remarks that stand in no brackets.
#include "analyzer/dialect/fanuc/remarks.hpp"

#include "analyzer/dialect/ascii.hpp"
#include "analyzer/dialect/fanuc/keywords.hpp"
#include "analyzer/dialect/fanuc/lexer.hpp"
#include "analyzer/dialect/numbers.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>

namespace maclint::fanuc {
namespace {

/// A remark that describes the program stands at its head.
constexpr std::size_t longest_head = 4000;

/// Bytes of a remark that are looked at.
constexpr std::size_t longest_remark = 256;
constexpr std::size_t longest_head_of_remark = 80;

/// Whether `P` and the number come next, blanks between them left out.
bool names_program(std::string_view text, std::int64_t number) {
    const auto skip = [&] {
        while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
    };
    skip();
    if (text.empty() || to_capital(text.front()) != 'P') return false;
    text.remove_prefix(1);
    skip();
    const auto* const end = std::ranges::find_if_not(text, is_digit);
    const std::string_view digits = text.substr(0, static_cast<std::size_t>(end - text.begin()));
    return !digits.empty() && read_integer(digits) == number;
}

bool calls(std::string_view remark, std::int64_t number) {
    for (auto six = remark.find('6', 1); six != std::string_view::npos; six = remark.find('6', six + 1)) {
        if (six + 2 >= remark.size()) return false;
        const bool code =
            to_capital(remark[six - 1]) == 'G' && (remark[six + 1] == '5' || remark[six + 1] == '6');
        if (code && names_program(remark.substr(six + 2), number)) return true;
    }
    return false;
}

constexpr bool is_word_byte(char c) { return is_letter(c) || static_cast<unsigned char>(c) > 0x7F; }

std::size_t words_for_people(std::string_view text) {
    const std::string capitals = in_capitals(text);
    std::size_t words = 0;
    for (auto begin = capitals.begin(); begin != capitals.end();) {
        begin = std::find_if(begin, capitals.end(), is_word_byte);
        const auto end = std::find_if_not(begin, capitals.end(), is_word_byte);
        words += is_for_people({begin, end}) ? 1 : 0;
        begin = end;
    }
    return words;
}

} // namespace

bool shows_own_call(std::string_view text, std::int64_t number) {
    text = text.substr(0, longest_head);
    for (auto at = text.find('('); at != std::string_view::npos; at = text.find('(', at)) {
        const Offset end = after_comment(text, static_cast<Offset>(at));
        if (calls(text.substr(at, end - at), number)) return true;
        at = end;
    }
    return false;
}

bool begins_sharp_remark(std::string_view text, std::size_t at) {
    if (at + 1 >= text.size() || text[at] != '#') return false;
    if (!is_blank(text[at + 1]) && !is_letter(text[at + 1])) return false;
    std::string_view rest = text.substr(at + 1, longest_head_of_remark);
    rest = rest.substr(0, rest.find_first_of("\r\n"));
    const auto* const first = std::ranges::find_if_not(rest, is_blank);
    if (first == rest.end() || !is_word_byte(*first)) return false;
    const bool has_sign = rest.find_first_of("=[]#") != std::string_view::npos;
    const std::size_t words = words_for_people(rest);
    return is_blank(rest.front()) ? words >= (has_sign ? 2U : 1U) : words >= 2 && !has_sign;
}

bool is_in_nested_remark(std::string_view text, std::size_t open, std::size_t at) {
    text = text.substr(0, open + longest_remark);
    const Offset comment_end = after_comment(text, static_cast<Offset>(open));
    if (comment_end >= at) return false;
    int depth = 0;
    bool is_inside = false;
    for (std::size_t i = open; i < text.size() && !is_line_break(text[i]); ++i) {
        if (i == at) is_inside = depth > 0;
        if (text[i] == '(') ++depth;
        if (text[i] == ')' && --depth == 0)
            return is_inside && words_for_people(text.substr(comment_end, i - comment_end)) != 0;
        if (i > at && !is_inside) return false;
    }
    return false;
}

} // namespace maclint::fanuc
