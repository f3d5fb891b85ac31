//! The table of functions.
#include "analyzer/dialect/fanuc/functions.hpp"

namespace maclint::fanuc {
namespace {

// Names and abbreviations: custom macro reference, section 3. POW needs two operands, PRM has no model.
// clang-format off
constexpr FunctionRow rows[] = {
    {"SIN", Operation::sine},          {"SI", Operation::sine},
    {"COS", Operation::cosine},        {"CO", Operation::cosine},
    {"TAN", Operation::tangent},       {"TA", Operation::tangent},
    {"ASIN", Operation::arc_sine},     {"AS", Operation::arc_sine},
    {"ACOS", Operation::arc_cosine},   {"AC", Operation::arc_cosine},
    {"ATAN", Operation::arc_tangent},  {"AT", Operation::arc_tangent},   {"ATN", Operation::arc_tangent},
    {"SQRT", Operation::square_root},  {"SQ", Operation::square_root},   {"SQR", Operation::square_root},
    {"ABS", Operation::absolute},      {"AB", Operation::absolute},
    {"ROUND", Operation::round},       {"RO", Operation::round},         {"RND", Operation::round},
    {"FIX", Operation::truncate},      {"FI", Operation::truncate},
    {"FUP", Operation::round_up},      {"FU", Operation::round_up},
    {"LN", Operation::logarithm},
    {"EXP", Operation::exponential},   {"EX", Operation::exponential},
    {"BIN", Operation::to_binary},     {"BI", Operation::to_binary},
    {"BCD", Operation::to_decimal_code}, {"BC", Operation::to_decimal_code},
    {"ADP", Operation::add_point},     {"AD", Operation::add_point},
    {"POW", Operation::power},         {"PRM", Operation::unknown},
};
// clang-format on

} // namespace

std::span<const FunctionRow> functions() { return rows; }

} // namespace maclint::fanuc
