//! Word lists.
#include "analyzer/dialect/dinplus/keywords.hpp"

#include "analyzer/dialect/ascii.hpp"
#include "analyzer/dialect/dinplus/sections.hpp"

#include <algorithm>

namespace maclint::dinplus {
namespace {

// l.19639-19882, l.2159, l.2406, l.19566-19627
constexpr std::string_view structural_words[] = {"IF",        "THEN",   "ELSE",       "ENDIF",   "WHILE",
                                                 "ENDWHILE",  "SWITCH", "CASE",       "DEFAULT", "BREAK",
                                                 "ENDSWITCH", "UNIT",   "END_OF_UNIT"};
constexpr std::string_view other_words[] = {"BLOCKSTART", "BLOCKEND", "RETURN", "PRINT", "INPUT", "WINDOW",
                                            "AND",        "OR",       "DEF",    "NDEF",  "DVDEF"};
// l.18895-18918
constexpr std::string_view functions[] = {"SIN",    "COS",    "TAN",  "ASIN",  "ACOS",  "ATAN", "ABS",
                                          "ROUND",  "INT",    "SQRT", "SQRTA", "SQRTS", "LOGN", "EXP",
                                          "BITSET", "STRING", "PARA", "PARAM", "TIME"};

struct Foreign {
    std::string_view word, meant;
};

// Words that other languages have and what DIN PLUS has for them; Finnish: as manuals print RETURN.
constexpr Foreign foreign_words[] = {
    {"ELSIF", ""},        {"ELSEIF", ""},
    {"ELIF", ""},         {"GOTO", ""},
    {"JUMP", ""},         {"CONTINUE", ""},
    {"CALL", ""},         {"WAIT", ""},
    {"NOT", ""},          {"MOD", ""},
    {"XOR", ""},          {"FOR", "WHILE"},
    {"UNTIL", "WHILE"},   {"REPEAT", "WHILE"},
    {"DO", ""},           {"NEXT", "ENDWHILE"},
    {"WEND", "ENDWHILE"}, {"ENDFOR", "ENDWHILE"},
    {"ENDW", "ENDWHILE"}, {"ENDCASE", "ENDSWITCH"},
    {"OUTPUT", "PRINT"},  {"WRITE", "PRINT"},
    {"READ", "INPUT"},    {"FIX", "INT"},
    {"TRUNC", "INT"},     {"SQR", "SQRT"},
    {"LN", "LOGN"},       {"LOG", "LOGN"},
    {"PALUU", "RETURN"},  {"NEQ", "<>"},
    {"EQU", "=="},
};

template<std::size_t N>
bool holds(const std::string_view (&words)[N], std::string_view word) {
    return std::ranges::find(words, word) != std::end(words);
}

/// The nearest word so far.
struct Nearest {
    std::string_view capitals;
    std::string_view word;
    std::size_t edits;

    void look_at(std::string_view candidate) {
        if (candidate.size() < 3 || edits == 0) return;
        const std::size_t distance = edit_distance(capitals, candidate, edits - 1);
        if (distance >= edits) return;
        edits = distance;
        word = candidate;
    }
};

} // namespace

bool is_function(std::string_view capitals) { return holds(functions, capitals); }
bool is_structural(std::string_view capitals) { return holds(structural_words, capitals); }

bool is_keyword(std::string_view capitals) {
    return is_structural(capitals) || holds(other_words, capitals) || holds(functions, capitals);
}

std::string meant_by(std::string_view capitals) {
    if (const auto* row = std::ranges::find(foreign_words, capitals, &Foreign::word);
        row != std::end(foreign_words))
        return std::string(row->meant);
    if (capitals.size() < 3) return {};
    const std::size_t most_edits = capitals.size() >= 6 ? 2 : 1;
    Nearest nearest{capitals, {}, most_edits + 1};
    for (const std::string_view word : structural_words) nearest.look_at(word);
    for (const std::string_view word : other_words) nearest.look_at(word);
    for (const std::string_view word : functions) nearest.look_at(word);
    for (const SectionWord& section : section_words())
        if (section.use != SectionWord::Use::translated) nearest.look_at(section.word);
    return std::string(nearest.word);
}

bool is_internal_constant(std::string_view name) {
    const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
    const std::size_t line = name.find('_');
    return line != std::string_view::npos && line > 1 && line + 1 < name.size() &&
           (name[0] == 'n' || name[0] == 'N') && std::ranges::all_of(name.substr(1, line - 1), is_digit);
}

} // namespace maclint::dinplus
