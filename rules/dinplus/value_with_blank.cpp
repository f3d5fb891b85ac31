//! DIN018: a blank within a variable.
#include "rules/rule.hpp"

namespace maclint::rules {

extern const Rule value_with_blank{
    .code = "DIN018",
    .name = "value-with-blank",
    .summary = "A blank stands within the name of a variable",
    .why = "Variables are written without blanks: the control may read two words.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .messages = {{"cure", "Blank in a variable: '{0}'.", "Write '{1}'."},
                 {"plain", "Blank in a variable: '{0}'."}},
    .bad = {{"dinplus", R"nc(
MACHINING
N10 # l1=62
N11 G0 X#l1 Z2
N99 M30
END
)nc"}},
    .good = {{"dinplus", R"nc(
MACHINING
N10 #l1 = 62
N11 G0 X#l1 Z2
N99 M30
END
)nc"}},
    .sources = {"SEED-003:18890"},
    .check = SyntaxErrorKind::blank_in_variable,
};

} // namespace maclint::rules
