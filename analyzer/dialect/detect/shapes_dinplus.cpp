//! The shapes of DIN PLUS: a fragment without a section word must still be told [dinplus.md 1-3].
#include "analyzer/dialect/detect/line_kinds.hpp"
#include "analyzer/dialect/detect/shapes.hpp"
#include "analyzer/dialect/dinplus/keywords.hpp"
#include "analyzer/dialect/dinplus/sections.hpp"
#include "analyzer/dialect/fanuc/keywords.hpp"

#include <algorithm>

namespace maclint::detect {
namespace {

constexpr bool is_small(char c) { return c >= 'a' && c <= 'z'; }
constexpr bool begins_number(char c) { return is_digit(c) || c == '-' || c == '+' || c == '.'; }

/// Whether `test(text, at)` holds at any place of `text` after `first`.
template<typename Test>
bool anywhere(std::string_view text, char first, Test test) {
    for (std::size_t at = text.find(first); at != std::string_view::npos; at = text.find(first, at + 1))
        if (test(text, at + 1)) return true;
    return false;
}

/// Whether a word that is no keyword stands outside of comments and texts.
bool has_word_for_people(std::string_view code) {
    const auto* const quote = std::ranges::find_if(code, [](char c) {
        return c == '[' || c == '"' || c == '#' || static_cast<unsigned char>(c) >= 0x80;
    });
    code = {code.begin(), quote};
    for (std::size_t at = 0; at < code.size();) {
        if (!is_capital(code[at])) {
            ++at;
            continue;
        }
        const auto* const begin = code.begin() + static_cast<std::ptrdiff_t>(at);
        const auto* const end = std::find_if_not(begin, code.end(), is_capital);
        const std::string_view word(begin, end);
        if (fanuc::is_for_people(word) && !dinplus::is_keyword(word)) return true;
        at = static_cast<std::size_t>(end - code.begin());
    }
    return false;
}

/// Whether a section word heads a line without a number, END (`end`) or another one; after it at most
/// addresses stand.
bool heads(const Line& line, bool end) {
    const std::string_view whole = line.whole();
    if (whole.size() < 3 || !is_capital(whole[0]) || !is_capital(whole[1])) return false;
    const auto ends_words = [](char c) {
        return !is_capital(c) && !is_blank(c) && c != '_' && static_cast<unsigned char>(c) < 0x80;
    };
    const auto* const after = std::ranges::find_if(whole, ends_words);
    constexpr std::string_view after_names = ":;=("; // a label, a call, an assignment
    if (after != whole.end() && after_names.find(*after) != std::string_view::npos) return false;
    const std::string_view head(whole.begin(), after);
    const auto section = dinplus::find_section(head);
    if (!section || (section->word->kind == "END") != end) return false;
    std::string_view rest = trim(head.substr(section->length));
    while (!rest.empty()) {
        const std::size_t blank = std::min(rest.find_first_of(" \t"), rest.size());
        if (blank > 2 && std::ranges::any_of(rest.substr(0, blank), is_capital)) return false;
        rest = trim(rest.substr(blank));
    }
    return true;
}

} // namespace

bool section_word(const Line& line) { return heads(line, false); }

bool end_of_program_word(const Line& line) { return heads(line, true); }

bool tool_feed_and_speed_in_one_block(const Line& line) {
    const Word* tool = line.word('T');
    if (tool == nullptr || tool->digits > 2 || line.word('F') == nullptr || line.word('S') == nullptr)
        return false;
    const bool feed = line.has('G', 930, 950) || line.has('G', 1930, 1950);
    const bool speed = line.has('G', 960, 970) || line.has('G', 1960, 1970);
    return feed && speed;
}

bool cycle_of_three_digits(const Line& line) {
    return line.has('G', 3000, 3999) || line.has('G', 4000, 4099) || line.has('G', 7000, 9989);
}

bool tool_change_point(const Line& line) { return line.has('G', 140, 140) && line.word('Q') != nullptr; }

bool c_axis_rapid_alone(const Line& line) {
    return line.words().size() == 2 && line.has('G', 1100, 1100) && line.word('C') != nullptr;
}

bool variable_with_letter(const Line& line) {
    constexpr std::string_view families = "LXCGINMDEWTA"; // dinplus.md 3.1
    return anywhere(line.whole(), '#', [&](std::string_view text, std::size_t at) {
        return at + 1 < text.size() && families.find(text[at]) != std::string_view::npos &&
               is_digit(text[at + 1]);
    });
}

bool named_variable(const Line& line) {
    return anywhere(line.as_written(), '#', [](std::string_view text, std::size_t at) {
        if (at >= text.size() || text[at] != '_') return false;
        const std::size_t name = text.find_first_not_of('_', at);
        return name != std::string_view::npos && is_small(text[name]);
    });
}

bool incremental_address(const Line& line) {
    return anywhere(line.as_written(), 'i', [](std::string_view text, std::size_t at) {
        if (at >= text.size() || at < 2 || !is_capital(text[at - 2])) return false;
        if (at >= 4 && is_capital(text[at - 3]) && is_capital(text[at - 4])) return false;
        return begins_number(text[at]) || text[at] == '#' || text[at] == '_';
    });
}

bool address_of_two_letters(const Line& line) {
    // Without those that stand in the expressions of others (NE, AND, OR).
    static constexpr std::string_view addresses[] = {"XK", "YK", "XE", "XS", "ZE", "ZS", "NS", "AN",
                                                     "BR", "BE", "BF", "BD", "FP", "WB", "RB", "CY"};
    const std::string_view code = line.code();
    for (std::size_t at = 0; at + 2 < code.size(); ++at) {
        if (!is_capital(code[at]) || !is_capital(code[at + 1]) || !begins_number(code[at + 2])) continue;
        const bool whole_word = at == 0 || !is_capital(code[at - 1]);
        if (whole_word && std::ranges::find(addresses, code.substr(at, 2)) != std::end(addresses))
            return true;
    }
    return false;
}

bool unknown_coordinate(const Line& line) {
    return anywhere(line.code(), '?', [](std::string_view text, std::size_t at) {
        return at >= 2 && text[at - 2] >= 'X' && text[at - 2] <= 'Z' && (at < 3 || !is_capital(text[at - 3]));
    });
}

bool slide(const Line& line) {
    const std::string_view whole = line.whole();
    if (whole.size() < 4 || whole[0] != '$' || !is_digit(whole[1])) return false;
    const std::string_view after = trim(whole.substr(2));
    return after.front() == 'N' || after.front() == '$';
}

bool file_name(const Line& line) {
    const std::string_view whole = line.whole();
    if (!whole.starts_with("%")) return false;
    const std::string_view name = whole.substr(1, whole.find_first_of(" \t", 1) - 1);
    return name.ends_with(".NC") || name.ends_with(".NCS") || name.ends_with(".JOB");
}

bool bracketed_remark(const Line& line) {
    const std::string_view code = line.code();
    static constexpr std::string_view others[] = {"IF", "WHILE", "DPRNT", "BPRNT", "SETVN", "O"};
    static constexpr std::string_view functions[] = {"SIN", "COS",   "TAN", "ASIN", "ACOS", "ATAN", "SQRT",
                                                     "ABS", "ROUND", "FIX", "FUP",  "EXP",  "LN",   "EXISTS"};
    if (starts_with_any(code, others)) return false;
    return anywhere(code, '[', [](std::string_view text, std::size_t at) {
        if (at >= 2 && !is_blank(text[at - 2])) return false;
        const std::string_view inside = trim(text.substr(at, text.find(']', at) - at));
        if (inside.find('#') != std::string_view::npos || starts_with_any(inside, functions)) return false;
        return inside.size() >= 3 && std::ranges::all_of(inside.substr(0, 3), is_capital);
    });
}

/// In DIN PLUS round brackets hold a value: without a variable a function, at most.
bool words_in_round_brackets(const Line& line) {
    const std::string_view comment = line.comment();
    if (comment.find_first_of("#_") != std::string_view::npos) return false;
    const auto* const begin = std::ranges::find_if(comment, is_capital);
    const auto* const end = std::find_if_not(begin, comment.end(), is_capital);
    return fanuc::is_for_people({begin, end}) ||
           (end != comment.end() && is_blank(*end) && begin == comment.begin());
}

/// Whether most lines of a text that bears marks of DIN PLUS can be read.
bool reads_as_din_plus(std::string_view text) {
    std::size_t read = 0, others = 0;
    bool in_comment = false;
    for_each_filled_line(text, [&](const Line& line, std::size_t) {
        const std::string_view whole = line.whole();
        const bool begun = in_comment;
        const std::size_t open = whole.rfind('[');
        const std::size_t close = whole.rfind(']');
        if (open != std::string_view::npos || close != std::string_view::npos)
            in_comment = close == std::string_view::npos || (open != std::string_view::npos && open > close);
        if (begun || section_word(line) || end_of_program_word(line)) return true;
        const bool is_other = is_capital(whole.front()) && has_word_for_people(line.code());
        (is_other ? others : read) += 1;
        return true;
    });
    return others <= read || others == 1;
}

bool elided_number(const Line& line) { return line.whole().starts_with("N.. "); }

} // namespace maclint::detect
