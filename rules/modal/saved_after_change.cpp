//! MAC517: a modal value is saved when the program has already changed it.
#include "analyzer/dataflow/conditions.hpp"
#include "analyzer/workspace/program_analysis.hpp"
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
    .aliases = "",
    .summary = "A modal value is saved after the program has already changed that group: what is "
               "put back is the program's own value",
    .why = "The caller comes back to the mode of the macro, although the macro looks as if it "
           "restored it.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .on_by_default = true,
    .off_reason = "",
    .data_flow = true,
    .messages = {{"own", "'{0}' saves the {1} after '{2}' has changed it: '{3}' puts back this program's "
                         "value, not the caller's. Save it first."}},
    .bad = {{"fanuc", "O9517(UP)\n"
                      "G91\n"
                      "#33=#4003\n"
                      "G0 Z10.\n"
                      "G#33\n"
                      "M99\n"}},
    .also = {},
    .good = {{"fanuc", "O9517(UP)\n"
                       "#33=#4003\n"
                       "G91\n"
                       "G0 Z10.\n"
                       "G#33\n"
                       "M99\n"}},
    .alarms = {},
    .sources = {"SEED-001:206,582"},
    .check = &check,
};

namespace {

/// The part that this program set, when the group cannot have been the caller's any more.
std::optional<dataflow::ModalPart> own_part(const ProgramAnalysis& analysis, const dataflow::Store& store,
                                            GroupId group) {
    const dataflow::ModalValue& value = analysis.data().modal(analysis.data().before(store.node), group);
    if (value.unknown || value.parts.empty()) return std::nullopt;
    for (const dataflow::ModalPart& part : value.parts)
        if (part.origin == 0 || analysis.data().pool().entry_group_of(part.symbol) == group)
            return std::nullopt;
    return value.parts.front();
}

/// The word that puts the saved value back and is still in force when the program returns.
const dataflow::ModalWrite* last_restore(const ProgramAnalysis& analysis, const dataflow::Store& store,
                                         GroupId group) {
    for (const dataflow::ModalWrite& write : analysis.facts().modal_writes) {
        if (!dataflow::plain_place(analysis.program(), write.expression)) continue;
        if (store_of(analysis, write.value) != &store) continue;
        for (const dataflow::ExitState& exit : analysis.facts().exits) {
            if (exit.exit.kind != flow::ExitKind::returns) continue;
            for (const dataflow::ModalPart& part : analysis.data().modal(exit.state, group).parts) {
                const dataflow::Origin& origin = analysis.data().origin(part.origin);
                if (origin.kind == dataflow::Origin::Kind::effect && origin.id == write.effect) return &write;
            }
        }
    }
    return nullptr;
}

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    if (analysis.is_main()) return;
    const Program& program = analysis.program();
    for (const dataflow::Store& store : analysis.facts().stores) {
        const auto* load = std::get_if<LoadModal>(&program.expressions[store.expression].node);
        if (load == nullptr) continue;
        const auto part = own_part(analysis, store, load->group);
        if (!part) continue;
        const dataflow::ModalWrite* restore = last_restore(analysis, store, load->group);
        if (restore == nullptr) continue;
        const Span span = program.effects[store.effect].span;
        const Span change = remark_at(analysis, part->origin, {}).span;
        Finding& finding = reporter.report(
            analysis.file(), span, "own",
            {quoted(program, span), std::string(analysis.control().groups[load->group].name),
             quoted(program, change), quoted(program, program.effects[restore->effect].span)});
        trace(finding, analysis, part->origin, "the program changes it here", store.node,
              "and saves it here");
        finding.related.push_back({&analysis.file(), program.effects[restore->effect].span,
                                   "this puts back the program's own value"});
    }
}

} // namespace
} // namespace maclint::rules
