//! SIN602: the number of a synchronised action.
#include "rules/rule.hpp"
#include "rules/syntax_errors.hpp"

namespace maclint::rules {

namespace {
void check(const ProgramFile& file, Reporter& reporter);
}

extern const Rule action_id{
    .code = "SIN602",
    .name = "action-id",
    .summary = "The number of a synchronised action is none from 1 to 255, or that of one that runs",
    .why = "Where there is no action of that number the control stops with an alarm. An action that gets the "
           "number of another one replaces it: what that one watched nobody watches any more.",
    .severity = Severity::error,
    .precision = Precision::high,
    .needs = {Capability::paired_words},
    .messages = {{"cure", "Number of an action: '{0}', which may be {1}.", "Choose one of them."},
                 {"again", "Action replaced: '{0}' is the number of '{1}', which still runs.",
                  "Give it another number, or end the first one with CANCEL."}},
    .bad = {{"sinumerik", R"nc(
ID=300 WHENEVER $A_IN[1]==1 DO M8
G1 X80 F100
M30
)nc"},
            {"sinumerik", R"nc(
ID=1 WHENEVER $A_IN[1]==1 DO $AC_OVR=50
ID=1 WHENEVER $A_IN[2]==1 DO M8
G1 X80 F100
M30
)nc"}},
    .good = {{"sinumerik", R"nc(
ID=3 WHENEVER $A_IN[1]==1 DO M8
G1 X80 F100
CANCEL(3)
ID=3 WHENEVER $A_IN[2]==1 DO M8
G1 X20
M30
)nc"}},
    .alarms = {{"SINUMERIK", "14025", "illegal modal ID of a synchronous action", false}},
    .sources = {"PGA p.343"},
    .check = &check,
};

namespace {

void check(const ProgramFile& file, Reporter& reporter) {
    report_syntax_error(file, SyntaxErrorKind::action_number, reporter);
    report_syntax_error(file, SyntaxErrorKind::action_again, reporter,
                        {.with_cure = "again", .severity = Severity::warning});
}

} // namespace
} // namespace maclint::rules
