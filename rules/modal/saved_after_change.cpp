//! MAC517: a modal value is saved when the program has already changed it.
#include "analyzer/dataflow/facts/exit_state.hpp"
#include "analyzer/dataflow/facts/modal_read.hpp"
#include "analyzer/dataflow/facts/modal_write.hpp"
#include "analyzer/dataflow/facts/store.hpp"
#include "analyzer/program/tables.hpp"
#include "analyzer/queries/conditions/conditions.hpp"
#include "analyzer/queries/modal/modal_parts.hpp"
#include "analyzer/queries/values/copies.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/modal/modal_leak.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"
#include "rules/trace.hpp"

#include <algorithm>
#include <set>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule saved_after_change{
    .code = "MAC517",
    .name = "saved-after-change",
    .summary = "A modal value is saved after the program has already changed that group: what is "
               "put back is the program's own value",
    .why = "The caller comes back to the mode of the macro, although the macro looks as if it "
           "restored it.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .facts =
        dataflow::facts<dataflow::ModalRead, dataflow::ModalWrite, dataflow::ExitState, dataflow::Store>(),
    .data_flow = true,
    .messages = {{"own",
                  "Saved too late: '{0}' saves the {1} after '{2}' has changed it, so '{3}' puts back this "
                  "program's value, not the caller's.",
                  "Save it before '{2}'."}},
    .bad = {{"fanuc", R"nc(
O9517(UP)
G91
#33=#4003
G0 Z10.
G#33
M99
)nc"}},
    .good = {{"fanuc", R"nc(
O9517(UP)
#33=#4003
G91
G0 Z10.
G#33
M99
)nc"}},
    .sources = {"SEED-001:206,582"},
    .check = &check,
};

namespace {

/// The part that this program set, when the group cannot have been the caller's any more.
std::optional<dataflow::ModalPart> own_part(const ProgramAnalysis& analysis,
                                            const dataflow::ModalRead& read) {
    if (read.value.unknown || read.value.parts.empty()) return std::nullopt;
    for (const dataflow::ModalPart& part : read.value.parts)
        if (queries::may_be_callers(analysis, read.group, part)) return std::nullopt;
    return read.value.parts.front();
}

void report(const ProgramAnalysis& analysis, Reporter& reporter, const dataflow::Store& store, GroupId group,
            const dataflow::ModalPart& part, const dataflow::ModalWrite& restore) {
    const Program& program = analysis.program();
    const Span span = program.effects[store.effect].span;
    Finding& finding = reporter.report(
        {analysis, store.effect}, span, "own",
        {quoted(program, span), std::string(analysis.control().groups[group].name),
         word_of(analysis, group, part), quoted(program, program.effects[restore.effect].span)});
    trace(finding, analysis, part.origin, "the program changes it here", store.node, "and saves it here");
    finding.related.push_back(
        {analysis.source(), program.effects[restore.effect].span, "this puts back the program's own value"});
}

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    if (analysis.is_main()) return;
    const Program& program = analysis.program();
    const std::vector<EffectId> effective = queries::effects_in_force_at_return(analysis);
    std::set<EffectId> known;
    for (const dataflow::ModalWrite& write : analysis.facts().all<dataflow::ModalWrite>()) {
        if (!queries::plain_variable(program, write.expression) ||
            !std::ranges::binary_search(effective, write.effect))
            continue;
        const dataflow::Store* store = queries::store_of(analysis, write.value);
        if (store == nullptr || known.contains(store->effect)) continue;
        const dataflow::ModalRead* read = queries::modal_read_of(analysis, *store);
        if (read == nullptr) continue;
        const auto part = own_part(analysis, *read);
        if (!part) continue;
        known.insert(store->effect);
        report(analysis, reporter, *store, read->group, *part, write);
    }
}

} // namespace
} // namespace maclint::rules
