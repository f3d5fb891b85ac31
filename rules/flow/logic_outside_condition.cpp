//! MAC329: AND and OR between conditions that no bracket holds together.
#include "rules/rule.hpp"

namespace maclint::rules {

extern const Rule logic_outside_condition{
    .code = "MAC329",
    .name = "logic-outside-condition",
    .summary = "AND or OR joins conditions outside of their brackets",
    .why = "The control takes one condition in one pair of brackets: IF[[..]AND[..]]. It stops at the"
           " AND of the open form, which some makers take.",
    .severity = Severity::error,
    .precision = Precision::very_high,
    .yields_to = "MAC122",
    .messages = {{"cure", "Logic outside the brackets of a condition: '{0}', and the control stops here.",
                  "Write '{1}'."},
                 {"plain", "Logic outside the brackets of a condition: '{0}', and the control stops here.",
                  "Put the whole in [ ]."},
                 {"elsewhere",
                  "Logic outside the brackets of a condition: the assumed control stops at '{0}'.",
                  "Put the whole in [ ], or name the control that takes it (--control {2})."}},
    .bad = {{"fanuc", R"nc(
O9329(CHOICE)
IF[#100EQ2]AND[#101EQ4]GOTO5
G0 X10.
N5 M30
)nc"}},
    .good = {{"fanuc", R"nc(
O9329(CHOICE)
IF[[#100EQ2]AND[#101EQ4]]GOTO5
G0 X10.
N5 M30
)nc"},
             {"nct", R"nc(
O9329(CHOICE)
IF[#100EQ2]OR[#101EQ4]GOTO5
G0 X10.
N5 M30
)nc"}},
    .alarms = {{"FANUC 16i/18i/21i", "125", "FORMAT ERROR IN MACRO"},
               {"FANUC 30i/0i-D", "1137", "IF STATEMENT FORMAT ERROR", true, "if-form"},
               {"FANUC 30i/0i-D", "1138", "WHILE STATEMENT FORMAT ERROR", true, "while-form"}},
    .sources = {"CNCWIKI-LOGIC", "SEED-002:334", "GH-ALM"},
    .check = SyntaxErrorKind::logic_outside_brackets,
};

} // namespace maclint::rules
