//! Follows the edges of each branch.
#include "analyzer/queries/fall_throughs.hpp"

#include <map>
#include <optional>
#include <utility>
#include <variant>

namespace maclint::queries {
namespace {

/// The nodes of the effects that divide and close branches.
std::map<EffectId, flow::NodeId> nodes_of_regions(const ProgramAnalysis& analysis) {
    std::map<EffectId, flow::NodeId> nodes;
    for (flow::NodeId node = 0; node < analysis.graph().nodes.size(); ++node) {
        const Slice effects = analysis.graph().nodes[node].effects;
        for (Id id = effects.first; id < effects.first + effects.count; ++id)
            if (std::holds_alternative<RegionMark>(analysis.program().effects[id].what))
                nodes.emplace(id, node);
    }
    return nodes;
}

/// Whether some path leads from the branch past the head of the next one. Nodes are in the order of the text:
/// the paths of BREAK go beyond the close, those of the test to the next head itself.
bool runs_into(const ProgramAnalysis& analysis, flow::NodeId branch, flow::NodeId next, flow::NodeId close) {
    for (flow::NodeId node = branch; node < next; ++node)
        for (const flow::EdgeId id : analysis.graph().out[node]) {
            const flow::NodeId to = analysis.graph().edges[id].to;
            if (next < to && to < close && analysis.data().passable(id)) return true;
        }
    return false;
}

} // namespace

std::vector<FallThrough> find_fall_throughs(const ProgramAnalysis& analysis) {
    const Program& program = analysis.program();
    std::vector<FallThrough> found;
    std::map<EffectId, flow::NodeId> nodes;
    for (const flow::Region& region : analysis.regions().all) {
        if (region.region_kind != RegionKind::selection || !region.close || region.crossed) continue;
        if (nodes.empty()) nodes = nodes_of_regions(analysis);
        std::optional<EffectId> branch;
        for (const EffectId part : region.parts) {
            if (std::get<RegionMark>(program.effects[part].what).part != RegionMark::Part::middle) continue;
            const auto before = std::exchange(branch, part);
            if (before && runs_into(analysis, nodes.at(*before), nodes.at(part), nodes.at(*region.close)))
                found.push_back({*before, part});
        }
    }
    return found;
}

} // namespace maclint::queries
