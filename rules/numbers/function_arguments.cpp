//! MAC729: a function with too few or too many arguments.
#include "rules/rule.hpp"

namespace maclint::rules {

extern const Rule function_arguments{
    .code = "MAC729",
    .name = "function-arguments",
    .aliases = "DIN335",
    .summary = "A function has another number of arguments than it takes",
    .why = "The control cannot calculate the function and stops in the block.",
    .severity = Severity::error,
    .precision = Precision::high,
    .messages = {{"cure", "Number of arguments: '{0}' takes {1}.", "Correct what stands in its brackets."}},
    .bad = {{"dinplus", R"nc(
MACHINING
N10 #l1=SQRTA(3)
N11 G0 X#l1 Z2
N99 M30
END
)nc"},
            {"sinumerik", R"nc(
R1=ATAN2(R2)
G0 X=SIN(30,R3)
M30
)nc"}},
    .good = {{"dinplus", R"nc(
MACHINING
N10 #l1=SQRTA(3,4)
N11 G0 X#l1 Z2
N99 M30
END
)nc"},
             {"sinumerik", R"nc(
R1=ATAN2(R2,R3)
G0 X=SIN(30)
M30
)nc"}},
    .alarms = {{"SINUMERIK", "14020", "wrong number of parameters in a call of a function or procedure",
                false}},
    .sources = {"HLS", "SEED-003:18895-18918", "SEED-003:19568", "SEED-003:19615"},
    .check = SyntaxErrorKind::argument_count,
};

} // namespace maclint::rules
