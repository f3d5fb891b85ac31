//! Word lists, and the search for the word that was meant.
#include "analyzer/dialect/fanuc/keywords.hpp"

#include "analyzer/dialect/ascii.hpp"
#include "analyzer/dialect/fanuc/functions.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <utility>

namespace maclint::fanuc {
namespace {

constexpr std::string_view control_words[] = {"IF", "THEN", "GOTO", "WHILE", "DO", "END"};
constexpr std::string_view operator_words[] = {"EQ",  "NE", "GT",  "GE",  "LT", "LE",
                                               "AND", "OR", "XOR", "MOD", "NOT"};
constexpr std::string_view output_words[] = {"POPEN", "PCLOS", "DPRNT", "BPRNT", "SETVN"};

struct Foreign {
    std::string_view word, meant;
    std::string_view advice = {};
};

// Words that other languages have, or that people expect, and what Custom Macro B has for them.
constexpr Foreign foreign_words[] = {
    {"LTE", "LE"},
    {"GTE", "GE"},
    {"LEQ", "LE"},
    {"GEQ", "GE"},
    {"NEQ", "NE"},
    {"EQU", "EQ"},
    {"EQUAL", "EQ"},
    {"EQL", "EQ"},
    {"THN", "THEN"},
    {"ENDW", "END"},
    {"ENDWHILE", "END"},
    {"WEND", "END"},
    {"GO", "GOTO"},
    {"GOTOF", "GOTO"},
    {"GOTOB", "GOTO"},
    {"JUMP", "GOTO"},
    {"RETURN", "M99"},
    {"RET", "M99"},
    {"CALL", "G65 P"},
    {"REPEAT", "WHILE"},
    {"UNTIL", "WHILE"},
    {"FOR", "WHILE"},
    {"NEXT", "END"},
    {"INT", "FIX"},
    {"TRUNC", "FIX"},
    {"ARCTAN", "ATAN"},
    {"ARCSIN", "ASIN"},
    {"ARCCOS", "ACOS"},
    {"MODULO", "MOD"},
    {"DIV", "/"},
    {"ENDFOR", "END"},
    {"ELSE", "", in_place_of_block_if},
    {"ELSEIF", "", in_place_of_block_if},
    {"ELSIF", "", in_place_of_block_if},
    {"ELIF", "", in_place_of_block_if},
    {"ENDIF", "", in_place_of_block_if},
};

bool holds(std::span<const std::string_view> words, std::string_view word) {
    return std::ranges::find(words, word) != words.end();
}

template<class Visit>
void for_each_keyword(const Visit& visit) {
    for (const std::string_view word : control_words) visit(word);
    for (const std::string_view word : operator_words) visit(word);
    for (const FunctionRow& function : functions()) visit(function.name);
    for (const std::string_view word : output_words) visit(word);
}

/// `RO` for ROUND: two letters, which other words hold by chance.
bool is_abbreviation(std::string_view capitals) {
    return capitals.size() == 2 && capitals != "LN" && is_function(capitals);
}

} // namespace

bool is_function(std::string_view capitals) {
    return std::ranges::find(functions(), capitals, &FunctionRow::name) != functions().end();
}

bool is_word_elsewhere(std::string_view capitals) {
    return std::ranges::find(foreign_words, capitals, &Foreign::word) != std::end(foreign_words);
}

bool is_operator_word(std::string_view capitals) { return holds(operator_words, capitals); }

bool is_keyword(std::string_view capitals) {
    return holds(control_words, capitals) || is_operator_word(capitals) || is_function(capitals) ||
           holds(output_words, capitals);
}

std::string_view comparison_word(std::string_view sign) {
    static constexpr std::pair<std::string_view, std::string_view> words[] = {
        {"=", "EQ"},  {"==", "EQ"}, {"<", "LT"},  {">", "GT"},  {"<=", "LE"},
        {"=<", "LE"}, {">=", "GE"}, {"=>", "GE"}, {"<>", "NE"}, {"!=", "NE"}};
    const auto* row = std::ranges::find(words, sign, &std::pair<std::string_view, std::string_view>::first);
    return row == std::end(words) ? std::string_view() : row->second;
}

bool is_misspelt_goto(std::string_view capitals, bool behind_if) {
    static constexpr std::string_view ends[] = {"GTO", "GOOTO", "GOTTO"};
    return (behind_if && capitals.ends_with("GOT")) ||
           std::ranges::any_of(ends, [&](std::string_view end) { return capitals.ends_with(end); });
}

std::vector<std::string_view> split_keywords(std::string_view capitals) {
    if (is_word_elsewhere(capitals)) return {}; // ENDWHILE
    // reach[i]: length of the keyword that ends at i and joins a row of keywords from the start, 0 for none.
    std::vector<std::uint8_t> reach(capitals.size() + 1, 0);
    for (std::size_t end = 1; end <= capitals.size(); ++end) {
        constexpr std::size_t longest = 5;
        for (std::size_t length = std::min(longest, end); length >= 2; --length) {
            const std::size_t begin = end - length;
            const std::string_view word = capitals.substr(begin, length);
            if (begin != 0 && reach[begin] == 0) continue;
            if (is_keyword(word) && (end == capitals.size() || !is_abbreviation(word))) { // SINE is no SI NE
                reach[end] = static_cast<std::uint8_t>(length);
                break;
            }
        }
    }
    std::vector<std::string_view> words;
    for (std::size_t end = capitals.size(); end > 0; end -= reach[end]) {
        if (reach[end] == 0) return {};
        words.push_back(capitals.substr(end - reach[end], reach[end]));
    }
    std::ranges::reverse(words);
    return words;
}

bool is_for_people(std::string_view capitals) {
    constexpr std::size_t shortest = 3; // bytes, as many as a character of Chinese takes
    if (capitals.size() < shortest || is_keyword(capitals) || is_word_elsewhere(capitals)) return false;
    if (is_function(capitals.substr(1)) || !split_keywords(capitals).empty()) return false; // XSIN[30]
    return split_keywords(capitals.substr(0, capitals.size() - 1)).empty();                 // THENG1, GOTON10
}

Misspelling explain(std::string_view capitals) {
    const auto* row = std::ranges::find(foreign_words, capitals, &Foreign::word);
    if (row != std::end(foreign_words)) return {true, std::string(row->meant), row->advice};
    if (capitals.size() < 3) return {false, {}, {}};
    std::string_view nearest;
    std::size_t least = capitals.size() >= 6 ? 2 : 1;
    for_each_keyword([&](std::string_view word) {
        if (word.size() < 3) return;
        const std::size_t edits = edit_distance(capitals, word, least);
        if (edits < least + (nearest.empty() ? 1 : 0)) {
            least = edits;
            nearest = word;
        }
    });
    return {!nearest.empty(), std::string(nearest), {}};
}

} // namespace maclint::fanuc
