//! Cycles of the flow graph that are never left.
#include "analyzer/dataflow/facts/call_made.hpp"
#include "analyzer/dataflow/loop_stops.hpp"
#include "analyzer/dataflow/loops.hpp"

#include <algorithm>
#include <span>
#include <utility>

namespace maclint::dataflow {
namespace {

class InescapableCycleSearch {
  public:
    InescapableCycleSearch(const Program& program, const flow::Regions& regions, const flow::Graph& graph,
                           const Analysis& analysis, const Cycles& cycles)
        : program_(program)
        , regions_(regions)
        , graph_(graph)
        , analysis_(analysis)
        , adjacency_(cycles.adjacency)
        , components_(cycles.components)
        , stops_(graph.nodes.size(), false) {
        for (const flow::Exit& exit : graph.exits) stops_[exit.node] = true;
        for (const CallMade& call : analysis.facts().all<CallMade>())
            stops_[call.node] = stops_[call.node] || (call.may_stop && !call.known);
        for (flow::NodeId node = 0; node < graph.nodes.size(); ++node) look_at_effects(node);
    }

    std::vector<Loop> run() {
        std::vector<Loop> inescapable_cycles;
        for (std::uint32_t component = 0; component < components_.members.size(); ++component) {
            if (!is_closed(component)) continue;
            if (const auto cycle = cycle_of(component); cycle && !a_call_may_stop(*cycle))
                inescapable_cycles.push_back(*cycle);
        }
        std::ranges::sort(inescapable_cycles, {}, &Loop::head);
        return inescapable_cycles;
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
            return analysis_.reached(node) && !stops_[node] && !adjacency_[node].empty() &&
                   std::ranges::all_of(adjacency_[node],
                                       [&](std::uint32_t to) { return components_.of[to] == component; });
        });
    }

    [[nodiscard]] bool a_call_may_stop(const Loop& cycle) const {
        bool may_stop = false;
        LoopStops stops(program_, graph_, analysis_, cycle);
        for_each_in_body(cycle, analysis_.facts().all<CallMade>(),
                         [&](const CallMade& call) { may_stop = may_stop || stops.may_stop_later(call); });
        return may_stop;
    }

    [[nodiscard]] std::optional<Loop> cycle_of(std::uint32_t component) const {
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
        Loop cycle;
        cycle.head = edge.to;
        cycle.latch = edge.from;
        cycle.back = *back;
        cycle.region = region_around(component);
        cycle.body.assign(body.begin(), body.end());
        cycle.exit_edges = std::move(never_taken);
        cycle.changes = LoopChanges(cycle, analysis_.facts());
        return cycle;
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
    [[nodiscard]] std::optional<flow::RegionId> region_around(std::uint32_t component) const {
        const std::span<const flow::NodeId> body = components_.members[component];
        const auto [first, last] =
            std::ranges::minmax(body, {}, [this](auto node) { return begin_of(node); });
        std::optional<flow::RegionId> around;
        for (auto id = regions_.loop_around(program_, begin_of(last)); id;
             id = regions_.all[*id].closed_around) {
            const auto head = graph_.node_of(regions_.all[*id].open);
            if (head && components_.of[*head] == component && begin_of(*head) <= begin_of(first)) around = id;
        }
        return around;
    }

    const Program& program_;
    const flow::Regions& regions_;
    const flow::Graph& graph_;
    const Analysis& analysis_;
    const flow::Adjacency& adjacency_;
    const flow::Components& components_;
    std::vector<bool> stops_; ///< nodes that end the program, pause, or may do either
};

} // namespace

std::vector<Loop> find_inescapable_cycles(const Program& program, const flow::Regions& regions,
                                          const flow::Graph& graph, const Analysis& analysis,
                                          const Cycles& cycles) {
    return InescapableCycleSearch(program, regions, graph, analysis, cycles).run();
}

} // namespace maclint::dataflow
