//! The shapes of signatures outside of DIN PLUS.
#include "analyzer/dialect/detect/shapes.hpp"

#include <algorithm>

namespace maclint::detect {
namespace {

bool has_code(const Line& line, char letter, std::int32_t code) {
    return line.has(letter, code * 10, code * 10);
}

std::size_t skip_digits(std::string_view text, std::size_t at) {
    while (at < text.size() && is_digit(text[at])) ++at;
    return at;
}

std::size_t skip_blanks(std::string_view text, std::size_t at) {
    while (at < text.size() && is_blank(text[at])) ++at;
    return at;
}

/// `name`, a number and `=`, as in `R10 =`, not inside a longer word.
bool assigns(std::string_view code, std::string_view name) {
    for (std::size_t at = code.find(name); at != std::string_view::npos; at = code.find(name, at + 1)) {
        if (at > 0 && (is_capital(code[at - 1]) || code[at - 1] == '_')) continue;
        const std::size_t digits = at + name.size();
        const std::size_t end = skip_digits(code, digits);
        const std::size_t sign = skip_blanks(code, end);
        if (end != digits && sign < code.size() && code[sign] == '=') return true;
    }
    return false;
}

} // namespace

bool tolerance_of_g64(const Line& line) { return has_code(line, 'G', 64) && line.word('P') != nullptr; }
bool probing_move(const Line& line) { return line.has('G', 382, 385); }
bool offset_by_l20(const Line& line) { return has_code(line, 'G', 10) && has_code(line, 'L', 20); }
bool digital_output(const Line& line) { return line.has('M', 620, 680) && line.word('P') != nullptr; }
bool extruder_zero(const Line& line) { return has_code(line, 'G', 92) && line.word('E') != nullptr; }
bool work_offset_by_g15(const Line& line) { return has_code(line, 'G', 15) && line.word('H') != nullptr; }
bool macro_call(const Line& line) {
    const std::string_view code = line.code();
    if (!code.starts_with('G')) return false;
    const std::string_view number = trim(code.substr(1));
    return (number.starts_with("65") || number.starts_with("66")) && code.find('P') != std::string_view::npos;
}

bool extrusion(const Line& line) {
    return line.has('G', 0, 10) && line.word('E') != nullptr &&
           (line.word('X') != nullptr || line.word('Y') != nullptr);
}

bool heater(const Line& line) {
    return line.word('S') != nullptr && (has_code(line, 'M', 104) || has_code(line, 'M', 109) ||
                                         has_code(line, 'M', 140) || has_code(line, 'M', 190));
}

bool program_number(const Line& line) {
    constexpr std::string_view beginnings = "O:%";
    if (beginnings.find(line.whole().front()) == std::string_view::npos) return false;
    std::string_view code = trim(line.whole().substr(0, line.whole().find('(')));
    while (!code.empty() && (code.back() == ';' || is_blank(code.back()))) code.remove_suffix(1);
    if (code.starts_with("%")) code.remove_prefix(1);
    if (code.size() < 2 || (code.front() != 'O' && code.front() != ':')) return false;
    const std::size_t number = skip_blanks(code, 1);
    return number != code.size() && skip_digits(code, number) == code.size();
}

bool loop(const Line& line) {
    return line.code().starts_with("WHILE") && line.code().find('[') != std::string_view::npos &&
           line.code().find("DO") != std::string_view::npos;
}

bool goto_after_condition(const Line& line) {
    const std::string_view code = line.code();
    if (!code.starts_with("IF")) return false;
    const std::size_t close = code.rfind(']');
    if (close == std::string_view::npos) return code.find("]GOTO") != std::string_view::npos;
    const std::string_view after = trim(code.substr(close + 1));
    return after.starts_with("GOTO") || after.starts_with("THEN") ||
           code.find("]THEN") != std::string_view::npos || code.find("]GOTO") != std::string_view::npos;
}

bool o_word(const Line& line) {
    const std::string_view code = line.code();
    if (code.size() < 3 || code.front() != 'O') return false;
    std::size_t at = skip_blanks(code, 1);
    if (at == code.size()) return false;
    if (code[at] == '<' || code[at] == '[') {
        at = code.find(code[at] == '<' ? '>' : ']', at);
        if (at == std::string_view::npos) return false;
        ++at;
    } else {
        const std::size_t digits = at;
        at = skip_digits(code, at);
        if (at == digits) return false;
    }
    static constexpr std::string_view words[] = {"SUB",    "ENDSUB",    "CALL",     "IF",      "ELSE",
                                                 "ENDIF",  "WHILE",     "ENDWHILE", "DO",      "REPEAT",
                                                 "RETURN", "ENDREPEAT", "BREAK",    "CONTINUE"};
    return starts_with_any(trim(code.substr(at)), words);
}

bool klartext_function(const Line& line) {
    const std::string_view code = line.code();
    if (!code.starts_with("FN")) return false;
    const std::size_t digits = skip_blanks(code, 2);
    const std::size_t end = skip_digits(code, digits);
    return end != digits && end < code.size() && code[end] == ':';
}

bool klartext_line(const Line& line) {
    static constexpr std::string_view heads[] = {"L X", "L Y",  "L Z", "L IX", "L IY",  "L IZ",
                                                 "L +", "CC X", "C X", "CR X", "LP PR", "CP IPA"};
    const std::string_view code = line.code();
    if (code.empty() || (code.front() != 'L' && code.front() != 'C')) return false;
    if (!starts_with_any(code, heads)) return false;
    return code.find_first_of("+-") != std::string_view::npos;
}

bool ends_in_star(const Line& line) { return line.code().size() > 1 && line.code().back() == '*'; }

bool r_parameter(const Line& line) { return assigns(line.code(), "R"); }

bool array_element(const Line& line) {
    const std::string_view code = line.code();
    const std::size_t name = code.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZ_");
    if (name == std::string_view::npos || name < 3 || code[name] != '[') return false;
    const std::size_t sign = code.find_first_not_of(" \t", code.find(']') + 1);
    return code.find(']') != std::string_view::npos && sign != std::string_view::npos && code[sign] == '=';
}

bool macro_definition(const Line& line) {
    return line.code().starts_with("DEFINE ") && line.code().find(" AS ") != std::string_view::npos;
}

bool osp_variable(const Line& line) { return assigns(line.code(), "VC"); }

bool condition_row(const Line& line) {
    const std::string_view code = line.code();
    if (code.empty() || (code.front() != 'E' && code.front() != 'H' && code.front() != 'C')) return false;
    return assigns(code.substr(0, code.find('=') + 1), code.substr(0, 1));
}

bool setting(const Line& line) {
    const std::string_view code = line.whole();
    if (code.size() < 2 || code.front() != '$') return false;
    if (code == "$H" || code == "$X" || code == "$$" || code == "$I" || code == "$#" || code == "$G")
        return true;
    const std::size_t end = skip_digits(code, 1);
    return end > 1 && end < code.size() && code[end] == '=';
}

bool osp_file_name(const Line& line) {
    return line.whole().starts_with("$") && line.whole().find(".MIN%") != std::string_view::npos;
}

bool citizen_cycle(const Line& line) {
    const auto words = line.words();
    if (words.size() != 1 || words[0].letter != 'G') return false;
    const std::int32_t code = words[0].tenths / 10;
    return code == 999 || (code >= 600 && code < 700 && code % 10 == 0);
}

bool tool_in_hundreds(const Line& line) {
    const auto words = line.words();
    return words.size() == 1 && words[0].letter == 'T' && words[0].digits == 3 && words[0].tenths % 1000 == 0;
}

bool language_switch(const Line& line) { return line.words().size() == 1 && line.has('G', 2900, 2910); }

bool path_mark(const Line& line) {
    const std::string_view code = line.whole().substr(0, line.whole().find('('));
    return trim(code).size() == 2 && code[0] == '$' && code[1] >= '1' && code[1] <= '4';
}

bool path_wait(const Line& line) {
    const std::string_view code = line.code();
    if (!code.starts_with('!')) return false;
    const std::size_t letter = code.find_first_not_of("!0123456789");
    return letter != std::string_view::npos && code[letter] == 'L' && letter + 1 < code.size() &&
           is_digit(code[letter + 1]);
}

bool assigns_l(const Line& line) { return assigns(line.code(), "L"); }

bool value_of_l(const Line& line) {
    constexpr std::string_view before = "XZUWIKF[";
    const std::string_view code = line.code();
    for (std::size_t at = code.find('L', 1); at != std::string_view::npos; at = code.find('L', at + 1))
        if (at + 1 < code.size() && is_digit(code[at + 1]) &&
            before.find(code[at - 1]) != std::string_view::npos)
            return true;
    return false;
}

bool open_directive(const Line& line) {
    static constexpr std::string_view heads[] = {"[BILLET",     "[EDGEMOVE",  "[TOOLDEF",
                                                 "[TOOLCOLOUR", "[STEP",      "[CLEAR",
                                                 "[TOLERANCE",  "[COMPONENT", "[SUBPROGRAM"};
    const std::string_view whole = line.whole();
    return starts_with_any(whole, heads) && whole.find_first_of("]#") == std::string_view::npos;
}

bool alignment_block(const Line& line) {
    const std::string_view whole = line.whole();
    const std::size_t number = whole.starts_with(':') ? skip_digits(whole, 1) : 0;
    const std::size_t code = skip_blanks(whole, number);
    constexpr std::string_view letters = "GTMXYZ";
    return number > 0 && code + 1 < whole.size() && letters.find(whole[code]) != std::string_view::npos &&
           is_digit(whole[code + 1]);
}

bool fadal_variable(const Line& line) { return line.whole().size() > 2 && is_digit(line.whole()[2]); }

bool fagor_head(const Line& line) {
    const std::string_view whole = line.whole();
    const std::size_t comma = whole.find(',');
    if (!whole.starts_with('%') || comma == std::string_view::npos || comma < 2) return false;
    const std::string_view rights = whole.substr(comma + 1, whole.find(',', comma + 1) - comma - 1);
    return !rights.empty() && rights.size() < 6 && rights.find_first_not_of("MX- ") == std::string_view::npos;
}

bool fagor_register(const Line& line) {
    const std::string_view code = line.code();
    const std::size_t sign = code.starts_with('P') ? skip_digits(code, 1) : 0;
    return sign > 1 && sign + 2 < code.size() && code[sign] == '=' &&
           (code[sign + 1] == 'K' || code[sign + 1] == 'P') && is_digit(code[sign + 2]);
}

bool fagor_statement(const Line& line) {
    static constexpr std::string_view heads[] = {"CALL ", "PCALL ", "MCALL ", "SUB ",   "ERROR ", "GOTO N",
                                                 "IF P",  "IF (P",  "RPT N",  "MSG \"", "MEXEC "};
    const std::string_view text = line.comment();
    constexpr std::string_view beginnings = "CPMSEGIR";
    if (text.empty() || beginnings.find(text.front()) == std::string_view::npos) return false;
    if (text == "RET") return true;
    const auto* const head =
        std::ranges::find_if(heads, [&](std::string_view h) { return text.starts_with(h); });
    if (head == std::end(heads)) return false;
    return text[head->size() - 1] == '"' || (head->size() < text.size() && is_digit(text[head->size()]));
}

bool fagor_parameter(const Line& line) {
    const std::string_view text = line.comment();
    const std::size_t sign = text.starts_with('P') ? skip_digits(text, 1) : 0;
    constexpr std::string_view values = "0123456789PK+-*/.() ";
    return sign > 1 && sign + 1 < text.size() && text[sign] == '=' &&
           text.find_first_not_of(values, sign + 1) == std::string_view::npos;
}

bool remark(const Line& line) {
    const std::string_view text = line.remark();
    const auto capital = std::ranges::find_if(text, is_capital);
    if (text.empty() || text.front() == '(' || capital == text.end()) return false;
    return !looks_like_block(text);
}

} // namespace maclint::detect
