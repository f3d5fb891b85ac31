//! MAC504: a called program leaves another motion mode than it found.
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

extern const Rule motion_mode_not_restored{
    .code = "MAC504",
    .name = "motion-mode-not-restored",
    .summary = "A called program leaves the motion mode (G00 to G03, G33) other than it found it",
    .why = "A caller that relies on its own G00 or G01 moves in the macro's mode instead.",
    .severity = Severity::note,
    .precision = Precision::medium,
    .on_by_default = false,
    .off_reason = "most programs give the motion code again after a call",
    .facts = dataflow::facts<dataflow::ExitState, dataflow::Store, dataflow::Clobber>(),
    .data_flow = true,
    .messages = {{"every-path",
                  "'{0}' is still in force when the program returns: the caller's motion mode is "
                  "lost. Save it at the start and put it back before M99."},
                 {"some-paths",
                  "'{0}' is still in force on some of the paths on which the program returns: the "
                  "caller's motion mode is lost there. Put it back on those, too."}},
    .bad = {{"fanuc", R"nc(
O9504(UP)
G0 Z10.
M99
)nc"}},
    .good = {{"fanuc", R"nc(
O9504(UP)
#33=#4001
G0 Z10.
G#33
M99
)nc"}},
    .sources = {"SEED-001:206"},
    .check = &check,
};

namespace {

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    if (analysis.is_main()) return;
    const auto leaks = queries::find_modal_leaks(
        analysis, RestorePolicy::motion, [&](const ModalGroup&, GroupId, const auto& exit, const auto& part) {
            return exit.exit.kind == flow::ExitKind::returns && queries::own_code(analysis, part).has_value();
        });
    for (const queries::ModalLeak& leak : leaks)
        report_leak(analysis, reporter, leak,
                    {analysis.control().spell(leak.group, *queries::own_code(analysis, leak.part))});
}

} // namespace
} // namespace maclint::rules
