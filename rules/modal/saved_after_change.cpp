//! MAC517: a modal value is saved when the program has already changed it.
#include "analyzer/dataflow/conditions.hpp"
#include "analyzer/dataflow/facts/exit_state.hpp"
#include "analyzer/dataflow/facts/modal_read.hpp"
#include "analyzer/dataflow/facts/modal_write.hpp"
#include "analyzer/dataflow/facts/store.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/modal/modal_leak.hpp"
#include "rules/modal/saved_state.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"
#include "rules/trace.hpp"

#include <algorithm>

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
    .data_flow = true,
    .messages = {{"own", "'{0}' saves the {1} after '{2}' has changed it: '{3}' puts back this program's "
                         "value, not the caller's. Save it first."}},
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
        if (part.origin == 0 || analysis.data().table().entry_group_of(part.symbol) == read.group)
            return std::nullopt;
    return read.value.parts.front();
}

/// The read that the store saves, when the store saves a modal group.
const dataflow::ModalRead* saved_read(const ProgramAnalysis& analysis, const dataflow::Store& store) {
    const auto& reads = analysis.facts().all<dataflow::ModalRead>();
    const auto read = std::ranges::find(reads, store.expression, &dataflow::ModalRead::expression);
    return read == reads.end() ? nullptr : &*read;
}

/// Words whose setting is still in force when the program returns.
std::vector<EffectId> effective_at_return(const ProgramAnalysis& analysis) {
    std::vector<EffectId> effects;
    for (const dataflow::ExitState& exit : analysis.facts().all<dataflow::ExitState>()) {
        if (exit.exit.kind != flow::ExitKind::returns) continue;
        for (std::size_t group = 0; group < analysis.control().groups.size(); ++group) {
            const dataflow::ModalValue value = analysis.data().modal(exit, static_cast<GroupId>(group));
            for (const dataflow::ModalPart& part : value.parts) {
                const dataflow::Origin& origin = analysis.data().origin(part.origin);
                if (origin.kind == dataflow::Origin::Kind::effect) effects.push_back(origin.id);
            }
        }
    }
    std::ranges::sort(effects);
    return effects;
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
    const std::vector<EffectId> effective = effective_at_return(analysis);
    std::vector<EffectId> known;
    for (const dataflow::ModalWrite& write : analysis.facts().all<dataflow::ModalWrite>()) {
        if (!dataflow::plain_variable(program, write.expression) ||
            !std::ranges::binary_search(effective, write.effect))
            continue;
        const dataflow::Store* store = store_of(analysis, write.value);
        if (store == nullptr || std::ranges::find(known, store->effect) != known.end()) continue;
        const dataflow::ModalRead* read = saved_read(analysis, *store);
        if (read == nullptr) continue;
        const auto part = own_part(analysis, *read);
        if (!part) continue;
        known.push_back(store->effect);
        report(analysis, reporter, *store, read->group, *part, write);
    }
}

} // namespace
} // namespace maclint::rules
