//! MAC518: a called program ends in the customary code without asking for the caller's.
#include "analyzer/dataflow/facts/call_made.hpp"
#include "analyzer/dataflow/facts/clobber.hpp"
#include "analyzer/dataflow/facts/exit_state.hpp"
#include "analyzer/dataflow/facts/modal_write.hpp"
#include "analyzer/dataflow/facts/read.hpp"
#include "analyzer/dataflow/facts/store.hpp"
#include "analyzer/program/tables.hpp"
#include "analyzer/queries/modal/modal_leaks.hpp"
#include "analyzer/queries/modal/modal_parts.hpp"
#include "analyzer/queries/values/copies.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/modal/modal_leak.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule modal_state_forced{
    .code = "MAC518",
    .name = "modal-state-forced",
    .summary = "A called program ends with a group set to its customary code (G90, G17, G94 ...) "
               "without having saved what the caller had",
    .why = "A caller in another mode comes back to the customary one, and its next words mean "
           "something else.",
    .severity = Severity::note,
    .precision = Precision::medium,
    .on_by_default = false,
    .off_reason = "ending in G90 is a custom that most shops rely on",
    .facts = dataflow::facts<dataflow::ExitState, dataflow::ModalWrite, dataflow::CallMade, dataflow::Read,
                             dataflow::Store, dataflow::Clobber>(),
    .data_flow = true,
    .messages =
        {{"forced",
          "Caller's {1} not restored: '{0}' is in force when the program returns, whatever it was before.",
          "Save it at the start and put it back before M99."}},
    .bad = {{"fanuc", R"nc(
O9518(UP)
G90 G0 Z10.
M99
)nc"}},
    .good = {{"fanuc", R"nc(
O9518(UP)
#33=#4003
G90 G0 Z10.
G#33
M99
)nc"}},
    .sources = {"SEED-001:206,582"},
    .check = &check,
};

namespace {

bool is_fault(const ProgramAnalysis& analysis, const ModalGroup& group, const dataflow::ExitState& exit,
              const dataflow::ModalPart& part) {
    if (exit.exit.kind != flow::ExitKind::returns || group.customary.size() != 1) return false;
    const auto code = queries::own_code(analysis, part);
    return code && *code == group.customary.front();
}

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    if (analysis.is_main()) return;
    const auto leaks =
        queries::find_modal_leaks(analysis, RestorePolicy::state,
                                  [&](const ModalGroup& group, GroupId, const auto& exit, const auto& part) {
                                      return is_fault(analysis, group, exit, part);
                                  });
    for (const queries::ModalLeak& leak : leaks) {
        if (!leak.on_every_path || queries::saves_group(analysis, leak.group)) continue;
        report_leak(analysis, reporter, leak, cause_at(analysis, leak.part.origin), "forced",
                    {analysis.control().spell(leak.group, *queries::own_code(analysis, leak.part)),
                     std::string(analysis.control().groups[leak.group].name)});
    }
}

} // namespace
} // namespace maclint::rules
