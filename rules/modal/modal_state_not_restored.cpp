//! MAC501: a called program leaves a modal group at a code that callers do not expect.
#include "analyzer/dataflow/facts/call_made.hpp"
#include "analyzer/dataflow/facts/clobber.hpp"
#include "analyzer/dataflow/facts/exit_state.hpp"
#include "analyzer/dataflow/facts/modal_write.hpp"
#include "analyzer/dataflow/facts/read.hpp"
#include "analyzer/dataflow/facts/store.hpp"
#include "analyzer/program/tables.hpp"
#include "analyzer/queries/modal/modal_leaks.hpp"
#include "analyzer/queries/modal/modal_parts.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/modal/modal_leak.hpp"
#include "rules/modal/modes_left_by_calls.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"

#include <algorithm>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule modal_state_not_restored{
    .code = "MAC501",
    .name = "modal-state-not-restored",
    .summary = "A called program leaves a modal group at a code that is not the customary one, on "
               "every exit or on some, or does not put back on every exit what it puts back on others",
    .why = "The caller goes on in another mode than the one it was written in: with G91 its next "
           "absolute position is an incremental move, with G18 its next arc lies in another "
           "plane.",
    .severity = Severity::warning,
    .precision = Precision::very_high,
    .facts = dataflow::facts<dataflow::ExitState, dataflow::ModalWrite, dataflow::CallMade, dataflow::Read,
                             dataflow::Store, dataflow::Clobber>(),
    .data_flow = true,
    .messages = {{"every-path", "{0} {1} is left to the caller.", "{2}."},
                 {"some-paths", "{0} {1} is left to the caller on some of the paths.", "{2}."},
                 {"by-call", "{0} {1} is left by '{2}': line {3} cuts in it, written for {4}.",
                  "Write {4} behind the call, or before the return of the called program."}},
    .bad = {{"fanuc", R"nc(
O9501(ONE STEP UP)
G91 G0 Z10.
M99
)nc"},
            {"fanuc", R"nc(
O9501(TO THE CORNER, Z)
#33=#4003
G90 G0 X0 Y0
IF[#26EQ#0]GOTO9
G0 Z#26
G#33
N9 M99
)nc"},
            {"fanuc", R"nc(
O9502(PIN)
G28 U0 W0
G21 G40 G97 G99
T0101
G1 X20. F0.1
M98 P9503
G1 X-0.8 F0.1
M30
O9503(BAR PULL)
G98 G1 Z5. F800.
M99
)nc"}},
    .good = {{"fanuc", R"nc(
O9501(ONE STEP UP)
#33=#4003
G91 G0 Z10.
G#33
M99
)nc"}},
    .exemptions = {{&queries::exemptions::only_sets_modes,
                    "only-sets-modes",
                    "A program that does nothing else is there to set them for its callers.",
                    {"fanuc", R"nc(
O9501(INTO THE PLANE OF THE ANGLE HEAD)
G18
M99
)nc"}},
                   {&queries::exemptions::returns_within,
                    "returns-within",
                    "M97 runs blocks of the program as a subprogram, whose M99 leads back into the program.",
                    {"fanuc", R"nc(
O9501(ROW OF HOLES)
G90 G0 X0
M97 P10
N10 G91 G0 Z1.
M99
)nc"}}},
    .sources = {"SEED-001:206,582", "CNCWIKI-SUB", "SEED-001:1344-1354"},
    .check = &check,
};

namespace {

/// A literal code of this program that is no custom.
bool is_unusual(const ProgramAnalysis& analysis, GroupId group, const dataflow::ModalPart& part) {
    const auto code = queries::own_code(analysis, part);
    const auto& customary = analysis.control().groups[group].customary;
    return code && std::ranges::find(customary, *code) == customary.end();
}

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    report_modes_left_by_calls(analysis, reporter);
    if (analysis.is_main()) return;
    const auto leaks = queries::find_modal_leaks(
        analysis, RestorePolicy::state,
        [&](const ModalGroup&, GroupId group, const auto& exit, const auto& part) {
            return exit.exit.kind == flow::ExitKind::returns && is_unusual(analysis, group, part);
        });
    for (const queries::ModalLeak& leak : leaks) {
        const bool is_for_another_rule = leak.kept && !leak.kept->is_put_back; // MAC507
        if (is_for_another_rule && !is_unusual(analysis, leak.group, leak.part)) continue;
        const auto own = queries::own_code(analysis, leak.part);
        const std::string code =
            own ? analysis.control().spell(leak.group, *own) : word_of(analysis, leak.group, leak.part);
        report_leak(analysis, reporter, leak, block_cause(analysis, leak.part),
                    leak.on_every_path ? "every-path" : "some-paths",
                    {capital_name(analysis, leak.group), code, cure_by_saving(analysis, leak)});
    }
}

} // namespace
} // namespace maclint::rules
