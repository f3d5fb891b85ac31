//! The table of functions.
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

// Counts: HLS, for ATAN2 and what follows NCI (test_arithmetic, test_string). POT is the square. ROUNDUP goes
// up also below zero: ROUNDUP(-3.1) is -3 [NCI], so it is not the round_up of other languages.
// clang-format off
constexpr FunctionRow rows[] = {
    {"ABS",      Operation::absolute,           1, 1, real},
    {"ACOS",     Operation::arc_cosine,         1, 1, real},
    {"ASIN",     Operation::arc_sine,           1, 1, real},
    {"ATAN2",    Operation::arc_tangent_of_two, 2, 2, real},
    {"BOUND",    none,                          3, 3, real},
    {"BTOI",     none,                          1, 1, whole},
    {"BTOR",     none,                          1, 1, real},
    {"COS",      Operation::cosine,             1, 1, real},
    {"EXP",      Operation::exponential,        1, 1, real},
    {"INDEX",    none,                          2, 2, whole},
    {"ISAXIS",   none,                          1, 1, truth},
    {"ISFILE",   none,                          1, 1, truth},
    {"ISNUMBER", none,                          1, 1, truth},
    {"ISVAR",    none,                          1, 1, truth},
    {"ITOB",     none,                          1, 1, truth},
    {"ITOR",     none,                          1, 1, real},
    {"LN",       Operation::logarithm,          1, 1, real},
    {"MATCH",    none,                          2, 2, whole},
    {"MAXVAL",   none,                          2, 2, real},
    {"MINDEX",   none,                          2, 2, whole},
    {"MINVAL",   none,                          2, 2, real},
    {"NUMBER",   none,                          1, 1, real},
    {"POT",      none,                          1, 1, real},
    {"RINDEX",   none,                          2, 2, whole},
    {"ROUND",    Operation::round,              1, 1, real},
    {"ROUNDUP",  none,                          1, 1, real},
    {"RTOB",     none,                          1, 1, truth},
    {"RTOI",     none,                          1, 1, whole},
    {"SIN",      Operation::sine,               1, 1, real},
    {"SQRT",     Operation::square_root,        1, 1, real},
    {"STRLEN",   none,                          1, 1, whole},
    {"SUBSTR",   none,                          2, 3, text},
    {"TAN",      Operation::tangent,            1, 1, real},
    {"TOLOWER",  none,                          1, 1, text},
    {"TOUPPER",  none,                          1, 1, text},
    {"TRUNC",    Operation::truncate,           1, 1, real},
};
// clang-format on
static_assert(std::ranges::is_sorted(rows, {}, &FunctionRow::name));

} // namespace

const FunctionRow* find_function(std::string_view capitals) {
    const auto* row = std::ranges::lower_bound(rows, capitals, {}, &FunctionRow::name);
    return row != std::end(rows) && row->name == capitals ? row : nullptr;
}

} // namespace maclint::sinumerik
