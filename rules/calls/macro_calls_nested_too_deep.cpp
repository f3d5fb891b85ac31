//! MAC410: one macro level too many.
#include "analyzer/program/tables.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/calls/call_depth.hpp"
#include "rules/rule.hpp"

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule macro_calls_nested_too_deep{
    .code = "MAC410",
    .name = "macro-calls-nested-too-deep",
    .summary = "Macro calls are nested deeper than the control allows",
    .why = "The control has a set of local variables for each level only up to its limit: the "
           "call beyond it raises an alarm in the middle of the job.",
    .severity = Severity::error,
    .precision = Precision::high,
    .needs = {Capability::macro_calls},
    .data_flow = true,
    .messages = {{"named", "Too many call levels: '{0}' is macro level {1}, and {2} has {3}: {4}.",
                  "Call it from a higher level."},
                 {"assumed",
                  "Too many call levels: '{0}' is macro level {1}, and the assumed control has {3}: {4}.",
                  "Call it from a higher level, or name the control (--control)."},
                 {"most",
                  "Too many call levels: '{0}' is macro level {1}, and no series has more than {3}: {4}.",
                  "Call it from a higher level."}},
    .bad = {{"fanuc", R"nc(
O0001(MAIN)
G65P9001
M30
O9001
G65P9002
M99
O9002
G65P9003
M99
O9003
G65P9004
M99
O9004
G65P9005
M99
O9005
M99
)nc"}},
    .good = {{"fanuc", R"nc(
O0001(MAIN)
G65P9001
M30
O9001
G65P9002
M99
O9002
G65P9003
M99
O9003
G65P9004
M99
O9004
M99
)nc"}},
    .alarms = {{"FANUC 16i/18i/21i", "122", "FOUR FOLD MACRO MODAL-CALL"},
               {"FANUC 30i/0i-D", "122", "TOO MANY MACRO NESTING"}},
    .sources = {"SEED-001:462", "MAN-PB278", "NCT-171", "CNCWIKI-CALL"},
    .check = &check,
};

namespace {

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    report_calls_beyond(analysis, reporter, NestingLimit::macro);
}

} // namespace
} // namespace maclint::rules
