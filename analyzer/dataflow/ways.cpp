//! Searches the flow graph for a way around assignments.
#include "analyzer/dataflow/ways.hpp"

#include "analyzer/dataflow/conditions.hpp"

#include <algorithm>
#include <utility>

namespace maclint::dataflow {
namespace {

constexpr std::size_t most_attempts = 8;

/// Sorted, without `except`.
std::vector<flow::NodeId> assigning_nodes(const Facts& facts, Place place, flow::NodeId except) {
    std::vector<flow::NodeId> nodes;
    for (const Store& store : facts.stores)
        if (store.place == place && store.node != except) nodes.push_back(store.node);
    return nodes;
}

void add_disturbing_nodes(const Facts& facts, Place place, flow::NodeId except,
                          std::vector<flow::NodeId>& nodes) {
    for (const Disturbance& disturbance : facts.disturbances)
        if (disturbance.node != except &&
            (disturbance.place ? *disturbance.place == place : disturbance.space == place.space))
            nodes.push_back(disturbance.node);
    std::ranges::sort(nodes);
}

/// The edge whose condition cannot turn out so on this way.
std::optional<flow::EdgeId> impossible_edge(const Program& program, const flow::Graph& graph,
                                            const Analysis& analysis, const std::vector<flow::EdgeId>& way) {
    std::vector<Decision> decisions;
    std::vector<flow::EdgeId> deciding;
    for (const flow::EdgeId id : way) {
        const flow::Edge& edge = graph.edges[id];
        if (!edge.condition) continue;
        decisions.push_back({*edge.condition, edge.holds});
        deciding.push_back(id);
    }
    const auto at = first_contradiction(program, decisions);
    return at ? std::optional(deciding[*at]) : analysis.first_impossible(way);
}

/// The edge leaves a loop, whose rounds meet none of the nodes: that it is not left before the first round
/// says nothing of the ways behind it.
bool only_counts_rounds(const flow::Graph& graph, flow::EdgeId edge, std::span<const flow::NodeId> barred) {
    const flow::NodeId head = graph.edges[edge].from;
    for (const flow::EdgeId in : graph.in[head]) {
        const flow::Edge& back = graph.edges[in];
        if (back.kind != flow::EdgeKind::back || graph.edges[edge].to <= back.from) continue;
        const auto first = std::ranges::lower_bound(barred, head);
        return first == barred.end() || *first > back.from;
    }
    return false;
}

/// A search of everything: what it does not find is not there.
std::size_t whole(const flow::Graph& graph) { return graph.nodes.size() + 1; }

} // namespace

bool assigned_on_every_way(const flow::Graph& graph, const Analysis& analysis, Place place,
                           flow::NodeId node) {
    const std::vector<flow::NodeId> assigning = assigning_nodes(analysis.facts(), place, node);
    const auto assigns = [&](flow::NodeId n) { return std::ranges::binary_search(assigning, n); };
    if (assigning.empty() || node == 0) return false;
    if (assigns(0)) return true;
    const auto usable = [&](flow::EdgeId edge) {
        return analysis.passable(edge) && !assigns(graph.edges[edge].to);
    };
    return !graph.way(0, node, usable, whole(graph));
}

std::vector<const Store*> last_stores_before(const flow::Graph& graph, const Analysis& analysis, Place place,
                                             const Loop& loop) {
    const auto& all = analysis.facts().stores;
    std::vector<const Store*> found;
    std::vector<bool> seen(graph.nodes.size(), false);
    std::vector<flow::NodeId> pending{loop.head};
    while (!pending.empty()) {
        const flow::NodeId node = pending.back();
        pending.pop_back();
        for (const flow::EdgeId edge : graph.in[node]) {
            const flow::NodeId from = graph.edges[edge].from;
            if (seen[from] || loop.holds(from) || !analysis.passable(edge)) continue;
            seen[from] = true;
            const Store* last = nullptr;
            for (auto store = std::ranges::lower_bound(all, from, {}, &Store::node);
                 store != all.end() && store->node == from; ++store)
                if (store->place == place) last = &*store;
            if (last != nullptr)
                found.push_back(last);
            else
                pending.push_back(from);
        }
    }
    return found;
}

std::optional<std::vector<flow::EdgeId>> way_without_assignment(const Program& program,
                                                                const flow::Graph& graph,
                                                                const Analysis& analysis, Place place,
                                                                flow::NodeId node) {
    std::vector<flow::NodeId> assigning = assigning_nodes(analysis.facts(), place, node);
    add_disturbing_nodes(analysis.facts(), place, node, assigning);
    if (node == 0) return std::vector<flow::EdgeId>{};
    if (std::ranges::binary_search(assigning, flow::NodeId{0})) return std::nullopt;
    std::vector<flow::EdgeId> impossible;
    while (impossible.size() < most_attempts) {
        const auto usable = [&](flow::EdgeId edge) {
            return analysis.passable(edge) && !std::ranges::binary_search(assigning, graph.edges[edge].to) &&
                   std::ranges::find(impossible, edge) == impossible.end();
        };
        auto way = graph.way(0, node, usable, whole(graph));
        if (!way) return std::nullopt;
        const auto bad = impossible_edge(program, graph, analysis, *way);
        if (!bad) return way;
        impossible.push_back(*bad);
    }
    return std::nullopt;
}

bool can_follow(const Program& program, const flow::Graph& graph, const Analysis& analysis,
                flow::NodeId first, flow::NodeId then, std::span<const flow::NodeId> barred) {
    std::vector<flow::EdgeId> impossible;
    const auto possible = [&](flow::EdgeId edge) {
        return analysis.passable(edge) && std::ranges::find(impossible, edge) == impossible.end();
    };
    const auto past = [&](flow::EdgeId edge) {
        const flow::NodeId next = graph.edges[edge].to;
        return possible(edge) && (next == then || !std::ranges::binary_search(barred, next));
    };
    while (impossible.size() < most_attempts) {
        using Way = std::optional<std::vector<flow::EdgeId>>;
        Way way = first == 0 ? Way(std::in_place) : graph.way(0, first, possible, whole(graph));
        const Way rest = first == then ? Way(std::in_place) : graph.way(first, then, past, whole(graph));
        if (!way || !rest) return false;
        way->insert(way->end(), rest->begin(), rest->end());
        const auto bad = impossible_edge(program, graph, analysis, *way);
        if (!bad || only_counts_rounds(graph, *bad, barred)) return true;
        impossible.push_back(*bad);
    }
    return false;
}

} // namespace maclint::dataflow
