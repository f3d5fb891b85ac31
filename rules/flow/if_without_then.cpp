//! MAC325: an IF that neither THEN nor GOTO follows.
#include "rules/rule.hpp"
#include "rules/syntax_errors.hpp"

namespace maclint::rules {

namespace {
void check(const ProgramFile& file, Reporter& reporter);
}

extern const Rule if_without_then{
    .code = "MAC325",
    .name = "if-without-then",
    .summary = "Neither THEN nor GOTO follows the condition of an IF",
    .why = "The control knows two forms: IF with a GOTO, and IF with THEN and one statement. It stops"
           " at any other. Some makers take a statement without THEN.",
    .severity = Severity::error,
    .precision = Precision::very_high,
    .yields_to = "MAC122 MAC118",
    .messages = {{"cure", "IF without THEN: the control stops at '{0}'.", "Write '{1}'."},
                 {"plain", "IF without THEN or GOTO: the control stops at '{0}'.",
                  "Let IF and GOTO jump over a block with it."},
                 {"elsewhere", "IF without THEN or GOTO: the assumed control stops at '{0}'.",
                  "Write THEN before an assignment, let a GOTO jump over words, or name the control"
                  " that takes it (--control {2})."},
                 {"alone", "IF with nothing after its condition: '{0}', and the control stops here.",
                  "Write a GOTO, or THEN with one statement, in the same block."}},
    .bad = {{"fanuc", R"nc(
O9325(DEPTH)
IF[#100LT0]#100=5.
G0 X#100
M30
)nc"},
            {"fanuc", R"nc(
O9325(CHOICE)
IF[#100EQ2]
G0 X10.
M30
)nc"}},
    .good = {{"fanuc", R"nc(
O9325(DEPTH)
IF[#100LT0]THEN#100=5.
IF[#100EQ5.]GOTO5
G0 X#100
N5 M30
)nc"},
             {"nct", R"nc(
O9325(DEPTH)
IF[#100LT0]#100=5.
G0 X#100
M30
)nc"}},
    .alarms = {{"FANUC 16i/18i/21i", "125", "FORMAT ERROR IN MACRO"},
               {"FANUC 30i/0i-D", "1137", "IF STATEMENT FORMAT ERROR"}},
    .sources = {"SEED-001:383", "SEED-002:360", "GH-ALM"},
    .check = &check,
};

namespace {

void check(const ProgramFile& file, Reporter& reporter) {
    report_syntax_error(file, SyntaxErrorKind::consequence_without_then, reporter);
    report_syntax_error(file, SyntaxErrorKind::condition_alone, reporter, {.without = "alone"});
}

} // namespace
} // namespace maclint::rules
