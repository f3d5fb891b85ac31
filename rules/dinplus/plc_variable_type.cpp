//! DIN333: a number of the PLC for a text, or the reverse.
#include "rules/rule.hpp"

namespace maclint::rules {

extern const Rule plc_variable_type{
    .code = "DIN333",
    .name = "plc-variable-type",
    .summary = "A text of the PLC is used as a number, or a number as a text",
    .why = "By #e0 and #e1 the PLC gives numbers, by #e2 texts; texts go into text variables alone, "
           "numbers into all others.",
    .severity = Severity::error,
    .precision = Precision::very_high,
    .messages = {{"cure", "Other type of the PLC: '{0}' stores {1} where the other one belongs.",
                  "Use #x1 to #x20 for #e2, and any other variable for #e0 and #e1."}},
    .bad = {{"dinplus", R"nc(
MACHINING
N10 #l1=#e2("PartName")
N11 PRINT("a",#l1)
N99 M30
END
)nc"}},
    .good = {{"dinplus", R"nc(
MACHINING
N10 #x1=#e2("PartName")
N11 #l1=#e1("CoolingOn")
N12 PRINT(#x1,#l1)
N99 M30
END
)nc"}},
    .sources = {"SEED-003:19075-19091"},
    .check = SyntaxErrorKind::other_plc_type,
};

} // namespace maclint::rules
