//! The table of functions and procedures.
#include "analyzer/dialect/sinumerik/functions.hpp"

#include <algorithm>
#include <iterator>

namespace maclint::sinumerik {
namespace {

constexpr auto real = VariableType::number;
constexpr auto whole = VariableType::integer;
constexpr auto text = VariableType::text;
constexpr auto truth = VariableType::truth;
constexpr auto none = Operation::unknown;

// Counts and types: HLS, for ATAN2 and what follows NCI (test_arithmetic, test_string). POT is the square.
// ROUNDUP goes up also below zero: ROUNDUP(-3.1) is -3 [NCI], so it is not the round_up of other languages.
// clang-format off
constexpr FunctionRow rows[] = {
    {"ABS",      Operation::absolute,           1, 1, real, "n"},
    {"AC",       none,                          1, 1, real, "n"},
    {"ACN",      none,                          1, 1, real, "n"},
    {"ACOS",     Operation::arc_cosine,         1, 1, real, "n"},
    {"ACP",      none,                          1, 1, real, "n"},
    {"ASIN",     Operation::arc_sine,           1, 1, real, "n"},
    {"ATAN2",    Operation::arc_tangent_of_two, 2, 2, real, "nn"},
    {"BOUND",    none,                          3, 3, real, "nnn"},
    {"BTOI",     none,                          1, 1, whole, ""},
    {"BTOR",     none,                          1, 1, real, ""},
    {"COS",      Operation::cosine,             1, 1, real, "n"},
    {"DC",       none,                          1, 1, real, "n"},
    {"DELETE",   none,                          2, 2, whole, "vt"},
    {"EXP",      Operation::exponential,        1, 1, real, "n"},
    {"GETT",     none,                          1, 2, whole, "tn"},
    {"IC",       none,                          1, 1, real, "n"},
    {"INDEX",    none,                          2, 2, whole, "t"},
    {"ISAXIS",   none,                          1, 1, truth, ""},
    {"ISFILE",   none,                          1, 1, truth, "t"},
    {"ISNUMBER", none,                          1, 1, truth, "t"},
    {"ISVAR",    none,                          1, 1, truth, "t"},
    {"ITOB",     none,                          1, 1, truth, ""},
    {"ITOR",     none,                          1, 1, real, ""},
    {"LN",       Operation::logarithm,          1, 1, real, "n"},
    {"MATCH",    none,                          2, 2, whole, "tt"},
    {"MAXVAL",   none,                          2, 2, real, "nn"},
    {"MINDEX",   none,                          2, 2, whole, "tt"},
    {"MINVAL",   none,                          2, 2, real, "nn"},
    {"NUMBER",   none,                          1, 1, real, "t"},
    {"POT",      none,                          1, 1, real, "n"},
    {"READ",     none,                          5, 5, whole, "vtnn"},
    {"RINDEX",   none,                          2, 2, whole, "t"},
    {"ROUND",    Operation::round,              1, 1, real, "n"},
    {"ROUNDUP",  none,                          1, 1, real, "n"},
    {"RTOB",     none,                          1, 1, truth, ""},
    {"RTOI",     none,                          1, 1, whole, ""},
    {"SETAL",    none,                          1, 2, whole, "nt"},
    {"SIN",      Operation::sine,               1, 1, real, "n"},
    {"SQRT",     Operation::square_root,        1, 1, real, "n"},
    {"STRLEN",   none,                          1, 1, whole, "t"},
    {"SUBSTR",   none,                          2, 3, text, "tnn"},
    {"TAN",      Operation::tangent,            1, 1, real, "n"},
    {"TOLOWER",  none,                          1, 1, text, "t"},
    {"TOUPPER",  none,                          1, 1, text, "t"},
    {"TRUNC",    Operation::truncate,           1, 1, real, "n"},
    {"WRITE",    none,                          3, 3, whole, "vtt"},
};
// clang-format on
static_assert(std::ranges::is_sorted(rows, {}, &FunctionRow::name));

} // namespace

const FunctionRow* find_function(std::string_view capitals) {
    const auto* row = std::ranges::lower_bound(rows, capitals, {}, &FunctionRow::name);
    return row != std::end(rows) && row->name == capitals ? row : nullptr;
}

} // namespace maclint::sinumerik
