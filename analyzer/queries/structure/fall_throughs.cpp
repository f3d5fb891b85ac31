//! Follows the edges of each branch.
#include "analyzer/queries/structure/fall_throughs.hpp"

#include "analyzer/source/budget.hpp"

#include <algorithm>
#include <optional>
#include <ranges>
#include <utility>
#include <variant>

namespace maclint::queries {
namespace {

/// Whether no block stands between the two: `CASE 1` and `CASE 2` have one branch.
bool share_a_branch(const Program& program, EffectId branch, EffectId next) {
    const auto item_at = [&](EffectId effect) {
        const auto items = std::views::iota(Id{0}, static_cast<Id>(program.items.size()));
        const Offset place = program.effects[effect].span.begin;
        const auto after = std::ranges::upper_bound(items, place, {},
                                                    [&](ItemId item) { return program.span_of(item).begin; });
        return after - items.begin();
    };
    return item_at(branch) + 1 == item_at(next);
}

/// Whether some path leads from the branch past the head of the next one. Nodes are in the order of the text:
/// the paths of BREAK go beyond the close, those of the test to the next head itself.
bool runs_into(const ProgramAnalysis& analysis, EffectId branch, EffectId next, EffectId close) {
    const flow::Graph& graph = analysis.graph();
    const auto begin = graph.node_of(branch), head = graph.node_of(next), end = graph.node_of(close);
    if (!begin || !head || !end) return false; // in a part that nothing executes
    for (flow::NodeId node = *begin; node < *head && Budget::allows(); ++node)
        for (const flow::EdgeId id : graph.out[node]) {
            const flow::NodeId to = graph.edges[id].to;
            if (*head < to && to < *end && analysis.data().passable(id)) return true;
        }
    return false;
}

} // namespace

std::vector<FallThrough> find_fall_throughs(const ProgramAnalysis& analysis) {
    const Program& program = analysis.program();
    std::vector<FallThrough> found;
    for (const flow::Region& region : analysis.regions().all) {
        if (region.region_kind != RegionKind::selection || !region.close || region.crossed) continue;
        std::optional<EffectId> branch;
        for (const EffectId part : region.parts) {
            if (std::get<RegionMark>(program.effects[part].what).part != RegionMark::Part::middle) continue;
            const auto before = std::exchange(branch, part);
            if (!before || share_a_branch(program, *before, part)) continue;
            if (runs_into(analysis, *before, part, *region.close)) found.push_back({*before, part});
        }
    }
    return found;
}

} // namespace maclint::queries
