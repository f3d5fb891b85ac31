//! Cycles of the flow graph that are never left.
#include "analyzer/dataflow/loops.hpp"

#include <algorithm>
#include <span>
#include <utility>

namespace maclint::dataflow {
namespace {

class TrapSearch {
  public:
    TrapSearch(const Program& program, const flow::Structures& structures, const flow::Graph& graph,
               const Analysis& analysis, const Cycles& cycles)
        : program_(program)
        , structures_(structures)
        , graph_(graph)
        , analysis_(analysis)
        , arrows_(cycles.arrows)
        , components_(cycles.components)
        , stops_(graph.nodes.size(), false) {
        for (const flow::Exit& exit : graph.exits) stops_[exit.node] = true;
        for (const CallMade& call : analysis.facts().calls)
            stops_[call.node] = stops_[call.node] || call.may_stop;
        for (flow::NodeId node = 0; node < graph.nodes.size(); ++node) look_at_effects(node);
    }

    std::vector<Loop> run() {
        std::vector<Loop> traps;
        for (std::uint32_t component = 0; component < components_.members.size(); ++component) {
            if (!is_closed(component)) continue;
            if (const auto trap = trap_of(component)) traps.push_back(*trap);
        }
        std::ranges::sort(traps, {}, &Loop::head);
        return traps;
    }

  private:
    void look_at_effects(flow::NodeId node) {
        const Slice effects = graph_.nodes[node].effects;
        for (Id id = effects.first; id < effects.first + effects.count; ++id) {
            const auto& what = program_.effects[id].what;
            if (std::holds_alternative<Stop>(what) || std::holds_alternative<UnreadableBlock>(what))
                stops_[node] = true;
        }
    }

    [[nodiscard]] bool is_closed(std::uint32_t component) const {
        return std::ranges::all_of(components_.members[component], [&](flow::NodeId node) {
            return analysis_.reached(node) && !stops_[node] && !arrows_[node].empty() &&
                   std::ranges::all_of(arrows_[node],
                                       [&](std::uint32_t to) { return components_.of[to] == component; });
        });
    }

    [[nodiscard]] std::optional<Loop> trap_of(std::uint32_t component) const {
        const std::span<const flow::NodeId> body = components_.members[component];
        std::optional<flow::EdgeId> back;
        std::vector<flow::EdgeId> never_taken;
        for (const flow::NodeId node : body)
            for (const flow::EdgeId id : graph_.out[node]) {
                if (components_.of[graph_.edges[id].to] != component) never_taken.push_back(id);
                if (leads_back(id) && (!back || comes_after(id, *back))) back = id;
            }
        if (!back) return std::nullopt;
        const flow::Edge& edge = graph_.edges[*back];
        Loop trap;
        trap.head = edge.to;
        trap.latch = edge.from;
        trap.back = *back;
        trap.structure = structure_around(component);
        trap.body.assign(body.begin(), body.end());
        trap.ways_out = std::move(never_taken);
        return trap;
    }

    [[nodiscard]] bool leads_back(flow::EdgeId id) const {
        const flow::Edge& edge = graph_.edges[id];
        return analysis_.passable(id) && edge.kind != flow::EdgeKind::next &&
               begin_of(edge.to) <= begin_of(edge.from);
    }

    [[nodiscard]] bool comes_after(flow::EdgeId a, flow::EdgeId b) const {
        return begin_of(graph_.edges[a].from) > begin_of(graph_.edges[b].from);
    }

    [[nodiscard]] Offset begin_of(flow::NodeId node) const { return graph_.nodes[node].part.begin; }

    /// The outermost loop of the text that runs round and round here: its head is in the cycle, and so is
    /// nothing outside of it.
    [[nodiscard]] std::optional<flow::StructureId> structure_around(std::uint32_t component) const {
        const std::span<const flow::NodeId> body = components_.members[component];
        const auto [first, last] =
            std::ranges::minmax(body, {}, [this](auto node) { return begin_of(node); });
        std::optional<flow::StructureId> around;
        for (auto id = structures_.loop_around(program_, begin_of(last)); id;
             id = structures_.all[*id].closed_around) {
            const auto head = graph_.node_of(structures_.all[*id].open);
            if (head && components_.of[*head] == component && begin_of(*head) <= begin_of(first)) around = id;
        }
        return around;
    }

    const Program& program_;
    const flow::Structures& structures_;
    const flow::Graph& graph_;
    const Analysis& analysis_;
    const flow::Arrows& arrows_;
    const flow::Components& components_;
    std::vector<bool> stops_; ///< nodes that end the program, pause, or may do either
};

} // namespace

std::vector<Loop> find_traps(const Program& program, const flow::Structures& structures,
                             const flow::Graph& graph, const Analysis& analysis, const Cycles& cycles) {
    return TrapSearch(program, structures, graph, analysis, cycles).run();
}

} // namespace maclint::dataflow
