//! MAC411: one subprogram level too many.
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/calls/call_depth.hpp"
#include "rules/rule.hpp"

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule subprogram_calls_nested_too_deep{
    .code = "MAC411",
    .name = "subprogram-calls-nested-too-deep",
    .aliases = "DIN501",
    .summary = "Subprogram calls are nested deeper than the control allows",
    .why = "The call beyond the control's limit raises an alarm in the middle of the job.",
    .severity = Severity::error,
    .precision = Precision::high,
    .on_by_default = true,
    .off_reason = "",
    .data_flow = true,
    .messages = {{"named",
                  "'{0}' is subprogram level {1}, and {2} has {3}: {4}. Call it from a higher level."},
                 {"assumed",
                  "'{0}' is subprogram level {1}, and a 16i has {3} (no control is named, so this limit"
                  " is assumed): {4}. Call it from a higher level, or name the control."}},
    .bad = {{"fanuc", "O0001(MAIN)\n"
                      "M98P9001\n"
                      "M30\n"
                      "O9001\n"
                      "M98P9002\n"
                      "M99\n"
                      "O9002\n"
                      "M98P9003\n"
                      "M99\n"
                      "O9003\n"
                      "M98P9004\n"
                      "M99\n"
                      "O9004\n"
                      "M98P9005\n"
                      "M99\n"
                      "O9005\n"
                      "M99\n"},
            {"dinplus", "MACHINING\n"
                        "N10 L\"S1\"\n"
                        "N20 M30\n"
                        "SUBPROGRAM \"S1\"\n"
                        "N30 L\"S2\"\n"
                        "RETURN\n"
                        "SUBPROGRAM \"S2\"\n"
                        "N40 L\"S3\"\n"
                        "RETURN\n"
                        "SUBPROGRAM \"S3\"\n"
                        "N50 L\"S4\"\n"
                        "RETURN\n"
                        "SUBPROGRAM \"S4\"\n"
                        "N60 L\"S5\"\n"
                        "RETURN\n"
                        "SUBPROGRAM \"S5\"\n"
                        "N70 L\"S6\"\n"
                        "RETURN\n"
                        "SUBPROGRAM \"S6\"\n"
                        "N80 L\"S7\"\n"
                        "RETURN\n"
                        "SUBPROGRAM \"S7\"\n"
                        "N90 G14 Q0\n"
                        "RETURN\n"
                        "END\n"}},
    .good = {{"fanuc", "O0001(MAIN)\n"
                       "M98P9001\n"
                       "M30\n"
                       "O9001\n"
                       "M98P9002\n"
                       "M99\n"
                       "O9002\n"
                       "M98P9003\n"
                       "M99\n"
                       "O9003\n"
                       "M98P9004\n"
                       "M99\n"
                       "O9004\n"
                       "M99\n"},
             {"dinplus", "MACHINING\n"
                         "N10 L\"S1\"\n"
                         "N20 M30\n"
                         "SUBPROGRAM \"S1\"\n"
                         "N30 L\"S2\"\n"
                         "RETURN\n"
                         "SUBPROGRAM \"S2\"\n"
                         "N40 L\"S3\"\n"
                         "RETURN\n"
                         "SUBPROGRAM \"S3\"\n"
                         "N50 L\"S4\"\n"
                         "RETURN\n"
                         "SUBPROGRAM \"S4\"\n"
                         "N60 L\"S5\"\n"
                         "RETURN\n"
                         "SUBPROGRAM \"S5\"\n"
                         "N70 L\"S6\"\n"
                         "RETURN\n"
                         "SUBPROGRAM \"S6\"\n"
                         "N80 G14 Q0\n"
                         "RETURN\n"
                         "END\n"}},
    .alarms = {{"FANUC 16i/18i/21i", "077", "SUB PROGRAM NESTING ERROR"},
               {"FANUC 30i/0i-D", "077", "TOO MANY SUB,MACRO NESTING"}},
    .sources = {"CNCWIKI-SUB", "RW-9", "SEED-003:10397", "SEED-003:19934"},
    .check = &check,
};

namespace {

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    report_calls_beyond(analysis, reporter, NestingLimit::subprogram,
                        analysis.control().limits.subprogram_calls);
}

} // namespace
} // namespace maclint::rules
