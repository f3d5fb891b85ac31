//! The rows.
#include "analyzer/dialect/dinplus/language_words.hpp"

namespace maclint::dinplus {
namespace {

using enum WordUse;

// clang-format off
constexpr LanguageWord rows[] = {
    {"IF",          keyword,    "begins a branch: THEN and perhaps ELSE follow, ENDIF closes it",    "SEED-003:19668"},
    {"THEN",        keyword,    "what is done where the condition of IF holds",                      "SEED-003:19668"},
    {"ELSE",        keyword,    "what is done where the condition of IF does not hold",              "SEED-003:19668"},
    {"ENDIF",       keyword,    "end of the branch",                                                 "SEED-003:19668"},
    {"WHILE",       keyword,    "repeated while the condition holds, up to ENDWHILE",                "SEED-003:19800"},
    {"ENDWHILE",    keyword,    "end of the loop",                                                   "SEED-003:19800"},
    {"SWITCH",      keyword,    "chooses a CASE by a variable, up to ENDSWITCH",                     "SEED-003:19845, T"},
    {"CASE",        keyword,    "what is done for this value, up to BREAK",                          "SEED-003:19845, T"},
    {"DEFAULT",     keyword,    "what is done for any other value",                                  "SEED-003:19845, T"},
    {"BREAK",       keyword,    "ends a CASE",                                                       "SEED-003:19845, T"},
    {"ENDSWITCH",   keyword,    "end of the choice",                                                 "SEED-003:19845, T"},
    {"RETURN",      keyword,    "end of a subprogram",                                               "SEED-003:19934, T"},
    {"PRINT",       statement,  "shows text and values of variables",                                "T"},
    {"INPUT",       statement,  "asks the user for a value",                                         "T"},
    {"WINDOW",      statement,  "opens a window for what is shown",                                  "T"},
    {"AND",         comparison, "both conditions",                                                   "SEED-003:19669"},
    {"OR",          comparison, "one of the conditions at least",                                    "SEED-003:19669"},
    {"DEF",         function,   "whether the variable has a value",                                  "SEED-003:19734"},
    {"NDEF",        function,   "whether the variable has no value",                                 "SEED-003:19734"},
    {"DVDEF",       function,   "whether the constant of the control has a value",                   "SEED-003:19738"},
    {"SIN",         function,   "sine of an angle in degrees",                                       "SEED-003:18895"},
    {"COS",         function,   "cosine of an angle in degrees",                                     "SEED-003:18895"},
    {"TAN",         function,   "tangent of an angle in degrees",                                    "SEED-003:18895"},
    {"ASIN",        function,   "angle of a sine in degrees",                                        "SEED-003:18895"},
    {"ACOS",        function,   "angle of a cosine in degrees",                                      "SEED-003:18895"},
    {"ATAN",        function,   "angle of a tangent in degrees",                                     "SEED-003:18895"},
    {"ABS",         function,   "number without its sign",                                           "SEED-003:18895"},
    {"ROUND",       function,   "nearest whole number",                                              "SEED-003:18895"},
    {"INT",         function,   "whole number without what stands behind the point",                 "SEED-003:18895"},
    {"SQRT",        function,   "square root",                                                       "SEED-003:18895"},
    {"SQRTA",       function,   "square root of a*a + b*b",                                          "SEED-003:18895"},
    {"SQRTS",       function,   "square root of a*a - b*b",                                          "SEED-003:18895"},
    {"LOGN",        function,   "natural logarithm",                                                 "SEED-003:18895"},
    {"EXP",         function,   "power of e",                                                        "SEED-003:18895"},
    {"BITSET",      function,   "1 or 0: a bit (0 to 15) of a number",                               "SEED-003:19648"},
    {"STRING",      function,   "text of a number",                                                  "SEED-003:19020"},
    {"PARA",        function,   "value of a parameter of the machine",                               "SEED-003:19393"},
    {"TIME",        function,   "date or time as text",                                              "SEED-003:19004"},
};
// clang-format on

// SEED-003:10404, 12483
constexpr NamePlace name_places[] = {
    {NamePlace::Names::program, "L\"", "L\""},
    {NamePlace::Names::block, "NS", "NS"},
    {NamePlace::Names::block, "NE", "NE"},
};

} // namespace

LanguageTables language_words() { return {rows, name_places}; }

} // namespace maclint::dinplus
