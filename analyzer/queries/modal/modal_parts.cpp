//! Reads the symbols of modal states.
#include "analyzer/queries/modal/modal_parts.hpp"

#include "analyzer/dataflow/facts/exit_state.hpp"
#include "analyzer/dataflow/facts/modal_write.hpp"
#include "analyzer/program/tables.hpp"
#include "analyzer/queries/values/origins.hpp"

#include <algorithm>
#include <variant>

namespace maclint::queries {

std::optional<double> code_of(const ProgramAnalysis& analysis, const dataflow::ModalPart& part) {
    return analysis.data().table().number_of(part.symbol);
}

std::optional<double> own_code(const ProgramAnalysis& analysis, const dataflow::ModalPart& part) {
    if (const auto id = effect_of_origin(analysis, part.origin)) {
        const Program& program = analysis.program();
        const Effect& effect = program.effects[*id];
        const auto* set = std::get_if<SetModal>(&effect.what);
        const auto* assign = std::get_if<Assign>(&effect.what);
        if (set == nullptr && assign == nullptr) return std::nullopt;
        const ExpressionId value = set != nullptr ? set->value : assign->value;
        if (!std::holds_alternative<Literal>(program.expressions[value].node)) return std::nullopt;
    }
    return code_of(analysis, part);
}

bool is_switched_on(const ProgramAnalysis& analysis, const ModalGroup& group,
                    const dataflow::ModalPart& part) {
    const auto code = own_code(analysis, part);
    return code && code != group.cancel && std::ranges::find(group.customary, *code) == group.customary.end();
}

bool may_be_callers(const ProgramAnalysis& analysis, GroupId group, const dataflow::ModalPart& part) {
    return part.origin == 0 || analysis.data().table().entry_group_of(part.symbol) == group;
}

NumberSource source_of(const ProgramAnalysis& analysis, const dataflow::ModalPart& part) {
    const dataflow::ValueTable& table = analysis.data().table();
    using Kind = dataflow::Symbol::Kind;
    switch (table.symbols[table.asked_for(part.symbol)].kind()) {
    case Kind::constant: return NumberSource::constant;
    case Kind::entry: return NumberSource::at_start;
    case Kind::result: return NumberSource::calculated;
    default: return NumberSource::other;
    }
}

bool sets_another_code(const ProgramAnalysis& analysis, const dataflow::PointState& point, ModalRole role) {
    const auto writes = analysis.facts().at<dataflow::ModalWrite>(point.effect);
    const auto group = writes.empty() ? std::nullopt : writes.front().group;
    if (!group || analysis.control().groups[*group].role != role) return false;
    const auto code = writes.front().value.constant();
    const dataflow::ModalValue value = analysis.data().modal(point, *group);
    return code && !value.unknown && !value.parts.empty() &&
           std::ranges::all_of(value.parts, [&](const dataflow::ModalPart& part) {
               const auto in_force = code_of(analysis, part);
               return in_force && *in_force != *code;
           });
}

std::vector<EffectId> effects_in_force_at_return(const ProgramAnalysis& analysis) {
    std::vector<EffectId> effects;
    for (const dataflow::ExitState& exit : analysis.facts().all<dataflow::ExitState>()) {
        if (exit.exit.kind != flow::ExitKind::returns) continue;
        for (std::size_t group = 0; group < analysis.control().groups.size(); ++group) {
            const dataflow::ModalValue value = analysis.data().modal(exit, static_cast<GroupId>(group));
            for (const dataflow::ModalPart& part : value.parts)
                if (const auto effect = effect_of_origin(analysis, part.origin)) effects.push_back(*effect);
        }
    }
    std::ranges::sort(effects);
    return effects;
}

} // namespace maclint::queries
