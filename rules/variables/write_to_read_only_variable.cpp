//! MAC203: a value is stored where it can only be read.
#include "rules/rule.hpp"

namespace maclint::rules {

extern const Rule write_to_read_only_variable{
    .code = "MAC203",
    .name = "write-to-read-only-variable",
    .aliases = "DIN304",
    .summary = "A value is stored in a variable that can only be read",
    .why = "The control owns the variable and tells its state by it: what is stored there is lost, or "
           "the control stops.",
    .severity = Severity::error,
    .severity_elsewhere = {{"dinplus", Severity::warning}},
    .precision = Precision::high,
    .messages = {{"cure", "Variable that can only be read: '{0}' holds {1}.",
                  "Store the value in a variable of your own, or program the function that sets it."}},
    .bad = {{"fanuc", R"nc(
O9203(PROBE)
G91 G28 Z0
#5063=#5063-0.5
M30
)nc"},
            {"dinplus", R"nc(
MACHINING
N10 #i21=0
N99 M30
END
)nc"}},
    .good = {{"fanuc", R"nc(
O9203(PROBE)
G91 G28 Z0
#100=#5063-0.5
M30
)nc"},
             {"dinplus", R"nc(
MACHINING
N10 #l1=#i21
N11 G4 F#l1
N99 M30
END
)nc"}},
    .alarms = {{"FANUC 16i/18i/21i", "116", "WRITE PROTECTED VARIABLE"},
               {"FANUC 30i/0i-D", "116", "WRITE PROTECTED VARIABLE"}},
    .sources = {"SEED-003:19105-19387", "SEED-001:1340-1378", "IMD-UI", "GH-ALM"},
    .check = SyntaxErrorKind::read_only_variable,
};

} // namespace maclint::rules
