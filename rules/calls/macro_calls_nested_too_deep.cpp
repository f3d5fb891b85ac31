//! MAC410: one macro level too many.
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
    .aliases = "",
    .summary = "Macro calls are nested deeper than the control allows",
    .why = "The control has a set of local variables for each level only up to its limit: the "
           "call beyond it raises an alarm in the middle of the job.",
    .severity = Severity::error,
    .precision = Precision::high,
    .on_by_default = true,
    .off_reason = "",
    .data_flow = true,
    .messages = {{"named", "'{0}' is macro level {1}, and {2} has {3}: {4}. Call it from a higher level."},
                 {"assumed",
                  "'{0}' is macro level {1}, and a 16i has {3} (no control is named, so this limit is "
                  "assumed): {4}. Call it from a higher level, or name the control."}},
    .bad = {{"fanuc", "O0001(MAIN)\n"
                      "G65P9001\n"
                      "M30\n"
                      "O9001\n"
                      "G65P9002\n"
                      "M99\n"
                      "O9002\n"
                      "G65P9003\n"
                      "M99\n"
                      "O9003\n"
                      "G65P9004\n"
                      "M99\n"
                      "O9004\n"
                      "G65P9005\n"
                      "M99\n"
                      "O9005\n"
                      "M99\n"}},
    .good = {{"fanuc", "O0001(MAIN)\n"
                       "G65P9001\n"
                       "M30\n"
                       "O9001\n"
                       "G65P9002\n"
                       "M99\n"
                       "O9002\n"
                       "G65P9003\n"
                       "M99\n"
                       "O9003\n"
                       "G65P9004\n"
                       "M99\n"
                       "O9004\n"
                       "M99\n"}},
    .alarms = {{"FANUC 16i/18i/21i", "122", "FOUR FOLD MACRO MODAL-CALL"},
               {"FANUC 30i/0i-D", "122", "TOO MANY MACRO NESTING"}},
    .sources = {"SEED-001:462", "MAN-PB278", "NCT-171", "CNCWIKI-CALL"},
    .check = &check,
};

namespace {

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    report_calls_beyond(analysis, reporter, NestingLimit::macro, analysis.control().limits.macro_calls);
}

} // namespace
} // namespace maclint::rules
