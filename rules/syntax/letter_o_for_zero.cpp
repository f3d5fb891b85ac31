//! MAC106: the letter O where the figure 0 belongs.
#include "rules/rule.hpp"
#include "rules/syntax_errors.hpp"

namespace maclint::rules {

namespace {
void check(const ProgramFile& file, Reporter& reporter);
}

extern const Rule letter_o_for_zero{
    .code = "MAC106",
    .name = "letter-o-for-zero",
    .aliases = "DIN025",
    .summary = "The letter O is typed for the figure 0",
    .why = "O begins a program number: the control finds an address without its value, or a code that"
           " it does not have, and stops. On the screen the two look alike.",
    .severity = Severity::error,
    .precision = Precision::very_high,
    .yields_to = "MAC122",
    .messages = {{"cure", "Letter O for the figure 0: '{0}', and the control stops here.", "Write '{1}'."},
                 {"jump",
                  "Letter O for the figure 0, or a GOTO without its TO: '{0}', and the control stops"
                  " here.",
                  "Write '{1}', or GOTO before the number."},
                 {"plain", "Letter O for the figure 0: '{0}', and the control stops here.",
                  "Write the figure."}},
    .bad = {{"fanuc", R"nc(
O9106(FACE)
GO1 X10. F100
G0 XO
M30
)nc"},
            {"fanuc", R"nc(
O9106(JUMP)
GO5
G0 X10.
N5 M30
)nc"},
            {"dinplus", R"nc(
MACHINING
N10 GO X60 Z2
N11 M3O
END
)nc"}},
    .good = {{"fanuc", R"nc(
O9106(FACE)
G01 X10. F100
G0 X0
M30
)nc"},
             {"dinplus", R"nc(
MACHINING
N10 G0 X60 Z2
N11 M30
END
)nc"}},
    .alarms = {{"FANUC 16i/18i/21i", "004", "ADDRESS NOT FOUND"},
               {"FANUC 16i/18i/21i", "010", "IMPROPER G-CODE"},
               {"SINUMERIK", "12080", "syntax error at the text shown", false}},
    .sources = {"CSDN-VAR", "CSDN-PS", "SEED-003:2227-2229"},
    .check = &check,
};

namespace {

void check(const ProgramFile& file, Reporter& reporter) {
    report_syntax_error(file, SyntaxErrorKind::letter_o, reporter);
    report_syntax_error(file, SyntaxErrorKind::letter_o_or_jump, reporter, {.with_cure = "jump"});
}

} // namespace
} // namespace maclint::rules
