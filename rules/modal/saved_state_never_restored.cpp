//! MAC507: a called program saves a modal state, changes it and puts it back nowhere.
#include "analyzer/dataflow/facts/call_made.hpp"
#include "analyzer/dataflow/facts/clobber.hpp"
#include "analyzer/dataflow/facts/exit_state.hpp"
#include "analyzer/dataflow/facts/modal_write.hpp"
#include "analyzer/dataflow/facts/read.hpp"
#include "analyzer/dataflow/facts/store.hpp"
#include "analyzer/program/modal_groups.hpp"
#include "analyzer/queries/modal/kept_state.hpp"
#include "analyzer/queries/modal/modal_leaks.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/modal/modal_leak.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"

#include <algorithm>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule saved_state_never_restored{
    .code = "MAC507",
    .name = "saved-state-never-restored",
    .summary = "A called program saves a modal state at its start, changes it, and puts it back nowhere",
    .why = "Its author wanted the caller to have its mode, feed or speed back, and the word that does it is "
           "missing: the caller goes on in the program's own.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .yields_to = "MAC501",
    .facts = dataflow::facts<dataflow::ExitState, dataflow::ModalWrite, dataflow::CallMade, dataflow::Read,
                             dataflow::Store, dataflow::Clobber>(),
    .data_flow = true,
    .messages = {{"never",
                  "Saved, but never put back: {0} is left to the caller, whose own '{1}' saves on line {2}.",
                  "{3}."}},
    .bad = {{"fanuc", R"nc(
O9507(UP, Z)
#33=#4003
G90 G0 Z#26
M99
)nc"},
            {"fanuc", R"nc(
O9507(PLUNGE, Z DEPTH F FEED)
#33=#4109
G1 Z#26 F#9
M99
)nc"}},
    .good = {{"fanuc", R"nc(
O9507(UP, Z)
#33=#4003
G90 G0 Z#26
G#33
M99
)nc"}},
    .sources = {"SEED-001:206,582"},
    .check = &check,
};

namespace {

constexpr RestorePolicy policies[] = {RestorePolicy::none, RestorePolicy::state, RestorePolicy::value,
                                      RestorePolicy::motion, RestorePolicy::offset};

void report(const ProgramAnalysis& analysis, Reporter& reporter, const queries::ModalLeak& leak) {
    const Program& program = analysis.program();
    const Span save = program.effects[leak.kept->save->effect].span;
    Finding& finding =
        report_leak(analysis, reporter, leak, block_cause(analysis, leak.part), "never",
                    {subject_of(analysis, leak), std::string(program.slice(save)),
                     line_number(analysis.file(), save.begin), cure_by_saving(analysis, leak)});
    finding.related.push_back({analysis.source(), save, "the caller's is saved here"});
}

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    if (analysis.is_main()) return;
    if (std::ranges::all_of(queries::find_kept_states(analysis), &queries::KeptState::is_put_back)) return;
    const auto nothing_else = [](const auto&...) { return false; };
    for (const RestorePolicy policy : policies)
        for (const queries::ModalLeak& leak : queries::find_modal_leaks(analysis, policy, nothing_else))
            if (leak.kept && !leak.kept->is_put_back) report(analysis, reporter, leak);
}

} // namespace
} // namespace maclint::rules
