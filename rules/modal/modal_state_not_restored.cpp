//! MAC501: a called program leaves a modal group at a code that callers do not expect.
#include "analyzer/dataflow/facts/call_made.hpp"
#include "analyzer/dataflow/facts/clobber.hpp"
#include "analyzer/dataflow/facts/exit_state.hpp"
#include "analyzer/dataflow/facts/modal_write.hpp"
#include "analyzer/dataflow/facts/store.hpp"
#include "analyzer/program/tables.hpp"
#include "analyzer/queries/modal_leaks.hpp"
#include "analyzer/queries/modal_parts.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/modal/modal_leak.hpp"
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
               "every exit or on some",
    .why = "The caller goes on in another mode than the one it was written in: with G91 its next "
           "absolute position is an incremental move, with G18 its next arc lies in another "
           "plane.",
    .severity = Severity::warning,
    .precision = Precision::very_high,
    .facts = dataflow::facts<dataflow::ExitState, dataflow::ModalWrite, dataflow::CallMade, dataflow::Store,
                             dataflow::Clobber>(),
    .data_flow = true,
    .messages = {{"every-path", "{0} {1} is left to the caller.", "{2}."},
                 {"some-paths", "{0} {1} is left to the caller on some of the paths.", "{2}."}},
    .bad = {{"fanuc", R"nc(
O9501(ONE STEP UP)
G91 G0 Z10.
M99
)nc"}},
    .good = {{"fanuc", R"nc(
O9501(ONE STEP UP)
#33=#4003
G91 G0 Z10.
G#33
M99
)nc"}},
    .sources = {"SEED-001:206,582", "CNCWIKI-SUB", "SEED-001:1344-1354"},
    .check = &check,
};

namespace {

/// A literal code of this program that is no custom.
bool is_fault(const ProgramAnalysis& analysis, const ModalGroup& group, const dataflow::ExitState& exit,
              const dataflow::ModalPart& part) {
    if (exit.exit.kind != flow::ExitKind::returns) return false;
    const auto code = queries::own_code(analysis, part);
    return code && std::ranges::find(group.customary, *code) == group.customary.end();
}

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    if (analysis.is_main()) return;
    const auto leaks =
        queries::find_modal_leaks(analysis, RestorePolicy::state,
                                  [&](const ModalGroup& group, GroupId, const auto& exit, const auto& part) {
                                      return is_fault(analysis, group, exit, part);
                                  });
    for (const queries::ModalLeak& leak : leaks) {
        const std::string code =
            analysis.control().spell(leak.group, *queries::own_code(analysis, leak.part));
        report_leak(analysis, reporter, leak, block_cause(analysis, leak.part),
                    leak.on_every_path ? "every-path" : "some-paths",
                    {capital_name(analysis, leak.group), code, cure_by_saving(analysis, leak)});
    }
}

} // namespace
} // namespace maclint::rules
