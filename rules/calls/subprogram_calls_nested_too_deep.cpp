//! MAC411: one subprogram level too many.
#include "analyzer/program/tables.hpp"
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
    .data_flow = true,
    .messages =
        {{"named", "Too many call levels: '{0}' is subprogram level {1}, and {2} has {3}: {4}.",
          "Call it from a higher level."},
         {"assumed",
          "Too many call levels: '{0}' is subprogram level {1}, and the assumed control has {3}: {4}.",
          "Call it from a higher level, or name the control (--control)."},
         {"most",
          "Too many call levels: '{0}' is subprogram level {1}, and no series has more than {3}: {4}.",
          "Call it from a higher level."}},
    .bad = {{"fanuc", R"nc(
O0001(MAIN)
M98P9001
M30
O9001
M98P9002
M99
O9002
M98P9003
M99
O9003
M98P9004
M99
O9004
M98P9005
M99
O9005
M99
)nc"},
            {"dinplus", R"nc(
MACHINING
N10 L"S1"
N20 M30
SUBPROGRAM "S1"
N30 L"S2"
RETURN
SUBPROGRAM "S2"
N40 L"S3"
RETURN
SUBPROGRAM "S3"
N50 L"S4"
RETURN
SUBPROGRAM "S4"
N60 L"S5"
RETURN
SUBPROGRAM "S5"
N70 L"S6"
RETURN
SUBPROGRAM "S6"
N80 L"S7"
RETURN
SUBPROGRAM "S7"
RETURN
END
)nc"}},
    .good = {{"fanuc", R"nc(
O0001(MAIN)
M98P9001
M30
O9001
M98P9002
M99
O9002
M98P9003
M99
O9003
M98P9004
M99
O9004
M99
)nc"},
             {"dinplus", R"nc(
MACHINING
N10 L"S1"
N20 M30
SUBPROGRAM "S1"
N30 L"S2"
RETURN
SUBPROGRAM "S2"
N40 L"S3"
RETURN
SUBPROGRAM "S3"
N50 L"S4"
RETURN
SUBPROGRAM "S4"
N60 L"S5"
RETURN
SUBPROGRAM "S5"
N70 L"S6"
RETURN
SUBPROGRAM "S6"
N80 G14 Q0
RETURN
END
)nc"}},
    .alarms = {{"FANUC 16i/18i/21i", "077", "SUB PROGRAM NESTING ERROR"},
               {"FANUC 30i/0i-D", "077", "TOO MANY SUB,MACRO NESTING"},
               {"SINUMERIK", "14012", "lowest subprogram level exceeded"}},
    .sources = {"CNCWIKI-SUB", "RW-9", "SEED-003:10397", "SEED-003:19934"},
    .check = &check,
};

namespace {

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    report_calls_beyond(analysis, reporter, NestingLimit::subprogram);
}

} // namespace
} // namespace maclint::rules
