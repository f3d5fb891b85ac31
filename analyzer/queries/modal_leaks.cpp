//! Reads the states in which a program is left.
#include "analyzer/queries/modal_leaks.hpp"

#include "analyzer/queries/origins.hpp"

#include <algorithm>
#include <cstddef>
#include <variant>

namespace maclint::queries {
namespace {

std::optional<ModalLeak> leak_of(const ProgramAnalysis& analysis, GroupId group, const IsFault& is_fault) {
    std::optional<ModalLeak> last;
    bool elsewhere_right = false;
    for (const dataflow::ExitState& exit : analysis.facts().all<dataflow::ExitState>()) {
        if (exit.exit.kind == flow::ExitKind::alarm) continue;
        const dataflow::ModalValue value = analysis.data().modal(exit, group);
        if (value.unknown) return std::nullopt;
        for (const dataflow::ModalPart& part : value.parts) {
            // A path on which nothing sets the group, as when a word is ignored, puts nothing back, nor does
            // a called program.
            if (part.origin == 0 || is_made_by_call(analysis, part.origin)) continue;
            const bool fault = is_fault(analysis.control().groups[group], group, exit, part);
            elsewhere_right |= !fault;
            if (fault && (!last || span_of_origin(analysis, last->part.origin).begin <
                                       span_of_origin(analysis, part.origin).begin))
                last = ModalLeak{group, part, &exit, true, {true, nullptr, {}}};
        }
    }
    if (!last) return std::nullopt;
    last->on_every_path = !elsewhere_right;
    if (last->exit->exit.kind == flow::ExitKind::returns) last->leak_use = leak_use_of(analysis, group);
    return last->leak_use.matters ? last : std::nullopt;
}

/// A jump of which it is unknown whether it is taken: to blocks that run as a subprogram of this program. A
/// return then need not leave it.
bool may_return_within(const Program& program) {
    return std::ranges::any_of(program.effects, [&](const Effect& effect) {
        const auto* guarded = std::get_if<Guarded>(&effect.what);
        return guarded != nullptr &&
               std::holds_alternative<Unreadable>(program.expressions[guarded->condition].node);
    });
}

} // namespace

std::vector<ModalLeak> find_modal_leaks(const ProgramAnalysis& analysis, RestorePolicy restore_policy,
                                        const IsFault& is_fault) {
    std::vector<ModalLeak> leaks;
    const auto& groups = analysis.control().groups;
    for (std::size_t group = 0; group < groups.size(); ++group) {
        if (groups[group].restore_policy != restore_policy) continue;
        if (const auto leak = leak_of(analysis, static_cast<GroupId>(group), is_fault))
            leaks.push_back(*leak);
    }
    if (!leaks.empty() && may_return_within(analysis.program())) leaks.clear();
    return leaks;
}

} // namespace maclint::queries
