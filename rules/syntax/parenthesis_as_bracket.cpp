//! MAC116: ( ) where an expression needs [ ].
#include "rules/rule.hpp"

namespace maclint::rules {

extern const Rule parenthesis_as_bracket{
    .code = "MAC116",
    .name = "parenthesis-as-bracket",
    .summary = "Round brackets make a comment: SIN(30) leaves SIN without its argument",
    .why = "The control skips what stands in ( ) and then finds a function, an operator or an "
           "address without a value: it stops with an alarm in this block. The key for '[' types"
           " '(' when a parameter says so.",
    .severity = Severity::error,
    .precision = Precision::very_high,
    .yields_to = "MAC122",
    .messages = {{"cure", "Round brackets make a comment, and '{0}' is left without its value.",
                  "Write '{1}'."},
                 {"plain", "Round brackets make a comment, and '{0}' is left without its value.",
                  "Write [ ]."}},
    .bad = {{"fanuc", R"nc(
O9116(ANGLE)
#100=SIN(30)
M30
)nc"}},
    .good = {{"fanuc", R"nc(
O9116(ANGLE)
#100=SIN[30]
M30
)nc"}},
    .alarms = {{"FANUC 16i/18i/21i", "114", "FORMAT ERROR IN MACRO", true, "expression"},
               {"FANUC 16i/18i/21i", "005", "NO DATA AFTER ADDRESS"},
               {"FANUC 30i/0i-D", "1125", "ILLEGAL EXPRESSION FORMAT", true, "expression"},
               {"FANUC 30i/0i-D", "005", "NO DATA AFTER ADDRESS"}},
    .sources = {"SEED-001:284", "MAN-16C287", "SINHA-EXP", "GH-ALM"},
    .check = SyntaxErrorKind::parenthesis_as_bracket,
};

} // namespace maclint::rules
