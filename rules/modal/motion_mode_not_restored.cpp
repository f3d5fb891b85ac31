//! MAC504: a called program leaves another motion mode than it found.
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
#include "rules/path.hpp"
#include "rules/rule.hpp"

#include <algorithm>
#include <string>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule motion_mode_not_restored{
    .code = "MAC504",
    .name = "motion-mode-not-restored",
    .summary = "A called program leaves rapid traverse to a caller whose next block, without a motion code, "
               "states a feed or goes on from its own G01, or puts the motion mode back on some exits only",
    .why = "The caller's block moves at rapid traverse instead of its feed: into the material, or a probe "
           "onto the workpiece without a skip.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .facts = dataflow::facts<dataflow::ExitState, dataflow::ModalWrite, dataflow::CallMade, dataflow::Read,
                             dataflow::Store, dataflow::Clobber>(),
    .data_flow = true,
    .messages = {{"feed",
                  "{0} is left to the caller, whose block in {1} states a feed and no motion code: it moves "
                  "at rapid traverse.",
                  "Write the motion code there."},
                 {"own",
                  "{0} is left to the caller, whose block in {1} goes on without a motion code: it moves at "
                  "rapid traverse.",
                  "Write the motion code there."},
                 {"not-put-back", "{0} is left to the caller on some of the paths.", "{1}."}},
    .bad = {{"fanuc", R"nc(
O0001(SLOT)
G90 G1 X50. F800.
M98 P9504
X100. F200.
M30
O9504(UP)
G0 Z10.
M99
)nc"}},
    .good = {{"fanuc", R"nc(
O0001(SLOT)
G90 G1 X50. F800.
M98 P9504
G1 X100. F200.
M30
O9504(UP)
G0 Z10.
M99
)nc"}},
    .sources = {"SEED-001:206"},
    .check = &check,
};

namespace {

/// A code under which no move asks for the feed.
bool is_rapid(const ProgramAnalysis& analysis, GroupId group, const dataflow::ModalPart& part) {
    const auto code = queries::own_code(analysis, part);
    return code && std::ranges::any_of(analysis.control().idle, [&](const Idle& idle) {
               return idle.under.group == group && idle.under.code == *code;
           });
}

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    if (analysis.is_main()) return;
    const auto leaks = queries::find_modal_leaks(
        analysis, RestorePolicy::motion,
        [&](const ModalGroup&, GroupId group, const auto& exit, const auto& part) {
            return exit.exit.kind == flow::ExitKind::returns && is_rapid(analysis, group, part);
        });
    for (const queries::ModalLeak& leak : leaks) {
        if (leak.kept) {
            if (leak.kept->is_put_back) // else MAC507
                report_leak(analysis, reporter, leak, block_cause(analysis, leak.part), "not-put-back",
                            {subject_of(analysis, leak), cure_by_saving(analysis, leak)});
            continue;
        }
        const queries::LeakUse& use = leak.leak_use;
        if (!use.gives_feed && !use.own_is_lost) continue;
        const std::string line = "line " + line_number(use.program->file(), use.block.begin);
        report_leak(analysis, reporter, leak, cause_at(analysis, leak.part.origin),
                    use.gives_feed ? "feed" : "own",
                    {analysis.control().spell(leak.group, *queries::own_code(analysis, leak.part)),
                     line + " of " + use.program->program().name});
    }
}

} // namespace
} // namespace maclint::rules
