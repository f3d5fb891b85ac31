//! Functions by what they compute, the other words in rows.
#include "analyzer/dialect/fanuc/language_words.hpp"

#include "analyzer/dialect/fanuc/functions.hpp"

#include <iterator>
#include <vector>

namespace maclint::fanuc {
namespace {

using enum WordUse;

// clang-format off
constexpr LanguageWord rows[] = {
    {"IF",    keyword,    "IF [condition] GOTO n, or IF [condition] THEN one statement",  "SEED-001:375"},
    {"THEN",  keyword,    "one statement, where the condition of IF holds",               "SEED-001:383"},
    {"GOTO",  keyword,    "jump to the block with the number",                            "SEED-001:371"},
    {"WHILE", keyword,    "WHILE [condition] DO m … END m: repeated while the condition holds", "SEED-001:395"},
    {"DO",    keyword,    "begins loop m, which END m closes",                            "SEED-001:395"},
    {"END",   keyword,    "end of loop m",                                                "SEED-001:395"},
    {"EQ",    comparison, "equal",                                                        "SEED-001:300"},
    {"NE",    comparison, "not equal",                                                    "SEED-001:300"},
    {"GT",    comparison, "greater",                                                      "SEED-001:300"},
    {"GE",    comparison, "greater or equal",                                             "SEED-001:300"},
    {"LT",    comparison, "less",                                                         "SEED-001:300"},
    {"LE",    comparison, "less or equal",                                                "SEED-001:300"},
    {"AND",   comparison, "both conditions; of numbers bit by bit",                       "SEED-001:300"},
    {"OR",    comparison, "one of the conditions at least; of numbers bit by bit",        "SEED-001:300"},
    {"XOR",   comparison, "one of the conditions alone; of numbers bit by bit",           "SEED-001:300"},
    {"MOD",   comparison, "rest of a division",                                           "SEED-001:300"},
    {"POPEN", statement,  "opens the output",                                             "ISORP, T"},
    {"PCLOS", statement,  "closes the output",                                            "ISORP, T"},
    {"DPRNT", statement,  "puts out text and values of variables",                        "T"},
    {"BPRNT", statement,  "puts out text and values of variables in binary",              "T"},
    {"SETVN", statement,  "gives variables names",                                        "T"},
};
// clang-format on

std::vector<LanguageWord> all_words() {
    std::vector<LanguageWord> all(std::begin(rows), std::end(rows));
    for (const FunctionRow& row : functions())
        all.push_back({row.name, function, what_it_computes(row.operation), "ZAPP-MATH"});
    return all;
}

// SEED-001:371, 423, 466; M98: CPH-M98
constexpr NamePlace name_places[] = {
    {NamePlace::Names::program, "G65", "P"},   {NamePlace::Names::program, "G66", "P"},
    {NamePlace::Names::program, "G66.1", "P"}, {NamePlace::Names::program, "M98", "P"},
    {NamePlace::Names::block, "GOTO", "GOTO"},
};

} // namespace

LanguageTables language_words() {
    static const std::vector<LanguageWord> all = all_words();
    return {all, name_places};
}

} // namespace maclint::fanuc
