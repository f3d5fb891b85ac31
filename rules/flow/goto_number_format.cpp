//! MAC305: a letter in front of the number of a jump.
#include "rules/rule.hpp"

namespace maclint::rules {

extern const Rule goto_number_format{
    .code = "MAC305",
    .name = "goto-number-format",
    .summary = "A GOTO names its target with a letter: GOTO N5",
    .why = "GOTO takes the number alone, a variable or brackets. The control stops at the letter.",
    .severity = Severity::error,
    .precision = Precision::very_high,
    .yields_to = "MAC122",
    .messages = {{"cure",
                  "Letter in the target of a jump: GOTO takes a number, and the control stops at"
                  " '{0}'.",
                  "Write 'GOTO{1}'."},
                 {"plain", "Letter in the target of a jump: GOTO takes a number, and the control stops at"
                           " '{0}'."}},
    .bad = {{"fanuc", R"nc(
O9305(CHOICE)
IF[#100EQ2]GOTO N5
G0 X10.
N5 M30
)nc"}},
    .good = {{"fanuc", R"nc(
O9305(CHOICE)
IF[#100EQ2]GOTO 5
G0 X10.
N5 M30
)nc"}},
    .alarms = {{"FANUC 16i/18i/21i", "114", "FORMAT ERROR IN MACRO"},
               {"FANUC 16i/18i/21i", "128", "ILLEGAL MACRO SEQUENCE NUMBER"}},
    .sources = {"IMD-114", "NCT-188"},
    .check = SyntaxErrorKind::letter_in_jump,
};

} // namespace maclint::rules
