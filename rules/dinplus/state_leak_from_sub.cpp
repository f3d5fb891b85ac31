//! DIN519: a subprogram returns with something switched on.
#include "analyzer/dataflow/facts/call_made.hpp"
#include "analyzer/dataflow/facts/clobber.hpp"
#include "analyzer/dataflow/facts/exit_state.hpp"
#include "analyzer/dataflow/facts/modal_write.hpp"
#include "analyzer/dataflow/facts/store.hpp"
#include "analyzer/queries/modal/left_active.hpp"
#include "analyzer/queries/modal/modal_leaks.hpp"
#include "analyzer/queries/modal/modal_parts.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/dinplus/left_active.hpp"
#include "rules/modal/modal_leak.hpp"
#include "rules/rule.hpp"

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule state_leak_from_sub{
    .code = "DIN519",
    .name = "state-leak-from-sub",
    .summary = "A subprogram returns with radius compensation, a tilted plane, mirroring or switched-off "
               "zero shifts that it switched on itself",
    .why = "The caller goes on with it, and nothing in the caller shows it: later moves go beside the "
           "contour, in another plane or to another place.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .facts = dataflow::facts<dataflow::ModalWrite, dataflow::CallMade, dataflow::ExitState, dataflow::Store,
                             dataflow::Clobber>(),
    .data_flow = true,
    .messages = {{"every-path",
                  "Code '{0}' is still active when the subprogram returns, and the caller goes on with it.",
                  "Write {1} before RETURN."},
                 {"some-paths",
                  "Code '{0}' is still active on some of the paths on which the subprogram returns.",
                  "Write {1} on those, too."}},
    .bad = {{"dinplus", R"nc(
%SEAT.ncs
MACHINING
N1 G0 X40 Z2
N2 G42
N3 G1 Z-18
N4 G0 X60
RETURN
)nc"}},
    .good = {{"dinplus", R"nc(
%SEAT.ncs
MACHINING
N1 G0 X40 Z2
N2 G42
N3 G1 Z-18
N4 G40
N5 G0 X60
RETURN
)nc"}},
    .sources = {"SEED-003:10357-10362", "SEED-003:12675",
                "SEED-003:20799 (a zero shift with G56 is left on deliberately)"},
    .check = &check,
};

namespace {

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    for (const queries::ModalLeak& leak : queries::left_at_return(analysis))
        report_leak(analysis, reporter, leak,
                    words_of(analysis, leak.group, *queries::own_code(analysis, leak.part)));
}

} // namespace
} // namespace maclint::rules
