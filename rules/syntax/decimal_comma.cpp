//! MAC126: a comma where the point of a number belongs.
#include "analyzer/program/faults.hpp"
#include "rules/rule.hpp"
#include "rules/syntax_errors.hpp"

namespace maclint::rules {

namespace {
void check(const ProgramFile& file, Reporter& reporter);
}

extern const Rule decimal_comma{
    .code = "MAC126",
    .name = "decimal-comma",
    .summary = "A number has a comma for its decimal point",
    .why = "The comma ends the number: the control stops at what stands behind it.",
    .severity = Severity::error,
    .precision = Precision::very_high,
    .yields_to = "MAC122",
    .messages = {{"cure", "Decimal comma in '{0}': the number ends at the comma, and the control stops here.",
                  "Write {1}."},
                 {"plain",
                  "Decimal comma in '{0}': the number ends at the comma, and the control stops here.",
                  "Write a decimal point."}},
    .bad = {{"fanuc", R"nc(
O9126(PLATE)
G90 G0 X1,5 Y0
M30
)nc"}},
    .good = {{"fanuc", R"nc(
O9126(PLATE, 1,5 THICK)
G90 G1 X1.5 ,R2. F100
M30
)nc"}},
    .alarms = {{"SINUMERIK", "12080", "syntax error at the text shown", false}},
    .sources = {"SEED-001:160; T: numbers have a point in all manuals"},
    .check = &check,
};

namespace {

void check(const ProgramFile& file, Reporter& reporter) {
    report_syntax_error(file, SyntaxErrorKind::unreadable, reporter, {.faults = {faults::decimal_comma}});
}

} // namespace
} // namespace maclint::rules
