//! MAC202: a variable that the control does not have.
#include "rules/rule.hpp"

namespace maclint::rules {

extern const Rule variable_number_out_of_range{
    .code = "MAC202",
    .name = "variable-number-out-of-range",
    .aliases = "DIN302",
    .summary = "There is no variable of this number",
    .why = "The control has a fixed set of variables, and stops at any other. Often a figure too many "
           "was typed.",
    .severity = Severity::error,
    .precision = Precision::high,
    .messages = {{"cure", "Variable that does not exist: '{0}', and the control stops here.",
                  "Use one of those that there are: {1}."},
                 {"plain", "Variable that does not exist: '{0}', and the control stops here.",
                  "Use a letter of the language, as in #l1, #c1, #g1 or #x1."},
                 {"unknown", "Variable that no manual lists: '{0}'.",
                  "Use one of those that are listed: {1}."}},
    .bad = {{"dinplus", R"nc(
MACHINING
N10 #l100=5
N11 G0 X#l100 Z2
N99 M30
END
)nc"}},
    .good = {{"dinplus", R"nc(
MACHINING
N10 #l10=5
N11 G0 X#l10 Z2
N99 M30
END
)nc"}},
    .sources = {"SEED-003:18946-18959", "SEED-003:19032-19387"},
    .check = SyntaxErrorKind::unknown_variable,
};

} // namespace maclint::rules
