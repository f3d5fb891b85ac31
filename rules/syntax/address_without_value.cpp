//! MAC109: an address without its number.
#include "rules/rule.hpp"

namespace maclint::rules {

extern const Rule address_without_value{
    .code = "MAC109",
    .name = "address-without-value",
    .summary = "An address stands without a number, a variable or brackets",
    .why = "The number was lost in typing or in a post processor. The control stops in the block,"
           " which may be hours into the job.",
    .severity = Severity::error,
    .precision = Precision::high,
    .yields_to = "MAC122 MAC401",
    .messages = {{"cure", "Address without a value: '{0}', and the control stops here.",
                  "Give it {1}, or delete it."},
                 {"plain", "Address without a value: '{0}', and the control stops here.",
                  "Give it a number, a variable or [ ], or delete it."},
                 {"elsewhere",
                  "Address without a value, unless the I after '{0}' makes it incremental: the assumed"
                  " control stops here.",
                  "Give it a value, or name the control that has such an I (--control {2})."},
                 {"unknown", "Address without a value: '{0}'. No manual says what the control makes of it.",
                  "Give it a number, a variable or [ ], or delete it."}},
    .bad = {{"fanuc", R"nc(
O9109(FACE)
G1 X Y10. F100
M30
)nc"},
            {"fanuc", R"nc(
O9109(BACK TO A BLOCK)
G0 X10.
M99 P
)nc"},
            {"dinplus", R"nc(
MACHINING
N10 G0 X Z2
N11 M30
END
)nc"}},
    .good = {{"fanuc", R"nc(
O9109(FACE)
G1 X5. Y10. F100
G0 X#100 Y[#101+2.]
M30
)nc"},
             {"dinplus", R"nc(
MACHINING
N10 #l1=60
N11 G0 X(#l1+2) Z2
N12 M30
END
)nc"}},
    .alarms = {{"FANUC 16i/18i/21i", "005", "NO DATA AFTER ADDRESS"},
               {"FANUC 30i/0i-D", "005", "NO DATA AFTER ADDRESS"},
               {"SINUMERIK", "12080", "syntax error at the text shown", false}},
    .sources = {"CSDN-PS", "GH-ALM", "SEED-003:10239-10246"},
    .check = SyntaxErrorKind::missing_value,
};

} // namespace maclint::rules
