//! Rows of variables, selectors, internal constants and functions.
#include "analyzer/dialect/dinplus/value_tables.hpp"

#include <algorithm>

namespace maclint::dinplus {
namespace {

constexpr std::int32_t most = 999'999;
constexpr std::int32_t any = SelectorRow::any_number;

// clang-format off
constexpr VariableRow variables[] = {
    {'l',   1,   99, Holds::number, Access::any,       "local variable",             "l.18946"},
    {'c',   1,   30, Holds::number, Access::any,       "channel variable",           "l.18956"},
    {'g',   1,  199, Holds::number, Access::any,       "global variable",            "l.18957, l.2723"},
    {'g', 200,  299, Holds::whole,  Access::any,       "whole global variable",      "l.18958, l.2723"},
    {'g', 500,  599, Holds::number, Access::reserved,  "the maker of the machine",   "l.2724"},
    {'g', 810,  815, Holds::number, Access::reserved,  "measuring cycles",           "l.2725, l.22232"},
    {'g', 950,  955, Holds::number, Access::reserved,  "structure programming",      "l.2726"},
    {'x',   1,   20, Holds::text,   Access::any,       "text variable",              "l.18959"},
    {'m',   1,   99, Holds::number, Access::any,       "machine dimension",          "l.19032"},
    {'d',   0, most, Holds::number, Access::any,       "tool compensation",          "l.19044"},
    {'e',   0,    1, Holds::number, Access::any,       "number of the PLC",          "l.19075"},
    {'e',   2,    2, Holds::text,   Access::any,       "text of the PLC",            "l.19077"},
    {'w',   0, most, Holds::number, Access::read_only, "tool data",                  "l.19105-19181"},
    {'t',   0, most, Holds::number, Access::read_only, "tool diagnosis",             "l.19205-19227"},
    {'n',   0,    0, Holds::number, Access::read_only, "current NC state",           "l.19235-19244"},
    {'n',  18,   18, Holds::number, Access::read_only, "current NC state",           "l.19245"},
    {'n',  40,   40, Holds::number, Access::read_only, "current NC state",           "l.19246"},
    {'n',  47,   47, Holds::number, Access::read_only, "current NC state",           "l.19247"},
    {'n',  52,   52, Holds::number, Access::read_only, "current NC state",           "l.19248"},
    {'n',  57,   58, Holds::number, Access::read_only, "current NC state",           "l.19249-19251"},
    {'n',  95,   95, Holds::number, Access::read_only, "current NC state",           "l.19252-19254"},
    {'n',  97,   97, Holds::number, Access::read_only, "current NC state",           "l.19255-19257"},
    {'n', 119,  120, Holds::number, Access::read_only, "current NC state",           "l.19258-19259"},
    {'n', 147,  148, Holds::number, Access::read_only, "current NC state",           "l.19260-19261, l.19293"},
    {'n', 150,  150, Holds::number, Access::read_only, "current NC state",           "l.19517-19518"},
    {'n', 601,  601, Holds::number, Access::read_only, "current NC state",           "l.19298"},
    {'n', 610,  610, Holds::number, Access::read_only, "current NC state",           "l.19306"},
    {'n', 707,  707, Holds::number, Access::read_only, "current NC state",           "l.19313"},
    {'n', 920,  920, Holds::number, Access::read_only, "current NC state",           "l.19321"},
    {'n', 927,  927, Holds::number, Access::read_only, "current NC state",           "l.18182"},
    {'n', 931,  931, Holds::number, Access::read_only, "current NC state",           "l.18567"},
    {'i',   1,   34, Holds::number, Access::read_only, "information of the control", "l.19333-19368"},
    {'i',  36,   36, Holds::number, Access::read_only, "information of the control", "l.19369"},
    {'i',  38,   39, Holds::number, Access::read_only, "information of the control", "l.19370-19371"},
    {'i',  99,   99, Holds::either, Access::read_only, "return value",               "l.19372"},
    {'a',   0,   10, Holds::number, Access::read_only, "interpolation data",         "l.18101-18120, l.22327"},
};

// What follows the letters C, X … is not printed for all: a list is a row only where it is whole.
constexpr SelectorRow selectors[] = {
    {'m', any, "X Y Z", "l.19032"},
    {'d', any, "X Y Z S", "l.19044"},
    {'w', any, "ID PT WT WTV WTH WTL NL HR NR AS ZZ RS ZD DF SD SB SL AL FB WL ZL XL YL TL I J K ZE XE YE DN HW NW EW SW AW MD "
               "CW BW AC ZS GH NE NS FP Q X Z Y DX DY DZ DS BR DC", "l.19115-19181"},
    {'t', any, "1 2 3 4 5 6 7 8", "l.19220-19227"},
    {'n',   0, "X Y Z A B C U V W CW", "l.19235-19244"},
    {'n',  18, "G",     "l.19245"},
    {'n',  40, "G",     "l.19246"},
    {'n',  47, "P",     "l.19247"},
    {'n',  52, "G",     "l.19248"},
    {'n',  57, "X Z",   "l.19249-19250"},
    {'n',  58, "P",     "l.19251"},
    {'n',  95, "G Q F", "l.19252-19254"},
    {'n',  97, "G Q S", "l.19255-19257"},
    {'n', 119, "Q G",   "l.19258, l.19287"},
    {'n', 120, "X",     "l.19259"},
    {'n', 147, "I K",   "l.19260-19261"},
    {'n', 148, "O",     "l.19293"},
    {'n', 150, "X Z",   "l.19517-19518"},
    {'n', 610, "H",     "l.19306"},
    {'n', 707, "X Y Z U V W A B C", "l.19313"},
    {'n', 920, "G",     "l.19321"},
    {'n', 927, "X Z Y", "l.18182"},
    {'n', 931, "H",     "l.18567"},
};

// l.19505-19525
constexpr std::string_view internal_constants =
    "n0_x n0_y n0_z n0_c n40_g n148_o n18_g n120_x n52_g n57_x n57_z n58_p n150_x n150_z n95_g n95_q n95_f n97_g n97_q n97_s";

constexpr FunctionRow functions[] = {
    {"ABS",    1, 1, Holds::number, Holds::number, "l.18902"},
    {"ROUND",  1, 1, Holds::number, Holds::number, "l.18903"},
    {"SQRT",   1, 1, Holds::number, Holds::number, "l.18904"},
    {"SQRTA",  2, 2, Holds::number, Holds::number, "l.18905"},
    {"SQRTS",  2, 2, Holds::number, Holds::number, "l.18906"},
    {"INT",    1, 1, Holds::number, Holds::number, "l.18907"},
    {"SIN",    1, 1, Holds::number, Holds::number, "l.18908"},
    {"COS",    1, 1, Holds::number, Holds::number, "l.18909"},
    {"TAN",    1, 1, Holds::number, Holds::number, "l.18910"},
    {"ASIN",   1, 1, Holds::number, Holds::number, "l.18911"},
    {"ACOS",   1, 1, Holds::number, Holds::number, "l.18912"},
    {"ATAN",   1, 1, Holds::number, Holds::number, "l.18913"},
    {"LOGN",   1, 1, Holds::number, Holds::number, "l.18914"},
    {"EXP",    1, 1, Holds::number, Holds::number, "l.18915"},
    {"BITSET", 2, 2, Holds::number, Holds::number, "l.18916, l.19652"},
    {"STRING", 1, 2, Holds::either, Holds::text,   "l.18917, l.19020-19027"},
    {"PARA",   3, 4, Holds::either, Holds::either, "l.18918, l.19397-19424"},
    {"PARAM",  3, 4, Holds::either, Holds::either, "l.2966"},
    {"TIME",   1, 1, Holds::text,   Holds::text,   "l.19004-19014"},
};
// clang-format on

std::string spelled(char letter, std::int32_t number) {
    return '#' + std::string(1, letter) + std::to_string(number);
}

} // namespace

bool contradict(Holds a, Holds b) {
    const auto is_number = [](Holds holds) { return holds == Holds::number || holds == Holds::whole; };
    return (a == Holds::text && is_number(b)) || (b == Holds::text && is_number(a));
}

std::string in_small_letters(std::string_view text) {
    std::string result(text);
    std::ranges::transform(result, result.begin(), [](char c) {
        return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    });
    return result;
}

const VariableRow* find_variable(char letter, std::int64_t number) {
    const auto* row = std::ranges::find_if(variables, [&](const VariableRow& range) {
        return range.letter == letter && range.first <= number && number <= range.last;
    });
    return row == std::end(variables) ? nullptr : row;
}

bool knows_all_numbers(char letter) {
    return std::string_view("lcxmet").find(letter) != std::string_view::npos;
}

std::string numbers_of(char letter) {
    std::string list;
    std::int32_t first = 0, last = -1;
    const auto close = [&] {
        if (last < 0) return;
        if (!list.empty()) list += ", ";
        list += spelled(letter, first) + (first == last ? "" : " to " + spelled(letter, last));
    };
    for (const VariableRow& row : variables) {
        if (row.letter != letter || row.access == Access::reserved) continue;
        if (last >= 0 && row.first == last + 1) {
            last = row.last;
            continue;
        }
        close();
        first = row.first;
        last = row.last;
    }
    close();
    return list;
}

const SelectorRow* selectors_of(char letter, std::int64_t number) {
    const auto* row = std::ranges::find_if(selectors, [&](const SelectorRow& list) {
        return list.letter == letter && (list.number == any || list.number == number);
    });
    return row == std::end(selectors) ? nullptr : row;
}

bool holds_word(std::string_view words, std::string_view word) {
    for (std::size_t begin = 0; begin < words.size();) {
        const std::size_t end = std::min(words.find(' ', begin), words.size());
        if (words.substr(begin, end - begin) == word) return true;
        begin = end + 1;
    }
    return false;
}

bool is_listed_constant(std::string_view name) { return holds_word(internal_constants, name); }

const FunctionRow* find_function(std::string_view capitals) {
    const auto* row = std::ranges::find(functions, capitals, &FunctionRow::name);
    return row == std::end(functions) ? nullptr : row;
}

std::string arguments_of(const FunctionRow& function) {
    static constexpr std::string_view counts[] = {"no", "one", "two", "three", "four"};
    std::string words(counts[function.least]);
    if (function.most != function.least) words += " or " + std::string(counts[function.most]);
    return words + (function.most == 1 ? " argument" : " arguments");
}

} // namespace maclint::dinplus
