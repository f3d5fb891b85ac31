//! Asks the search for paths around assignments.
#include "analyzer/queries/paths/feasible_paths.hpp"

#include "analyzer/dataflow/facts/clobber.hpp"
#include "analyzer/flow/walk.hpp"
#include "analyzer/source/budget.hpp"

#include <algorithm>
#include <array>

namespace maclint::queries {
std::vector<flow::NodeId> nodes_that_may_change(const ProgramAnalysis& analysis, Variable variable,
                                                flow::NodeId except) {
    const dataflow::Facts& facts = analysis.facts();
    const auto stores = facts.about<dataflow::Store>(variable);
    const auto clobbers = facts.all<dataflow::Clobber>();
    std::vector<flow::NodeId> nodes;
    if (!Budget::allows(stores.size() + clobbers.size())) return nodes;
    for (const dataflow::Store* store : stores)
        if (store->node != except) nodes.push_back(store->node);
    for (const dataflow::Clobber& clobber : clobbers)
        if (clobber.node != except && clobber.may_change(variable)) nodes.push_back(clobber.node);
    std::ranges::sort(nodes);
    return nodes;
}

std::vector<bool> WithoutAssignment::reach_of(Variable variable, const Reach& reach) const {
    const flow::Graph& graph = analysis_.graph();
    std::vector<bool> ends(graph.nodes.size(), false);
    for (const dataflow::Store* store : analysis_.facts().about<dataflow::Store>(variable))
        ends[store->node] = true;
    std::vector<bool> reached(graph.nodes.size(), false);
    reached[0] = true;
    if (ends[0]) return reached;
    for (const flow::NodeId node : reach.excluded) ends[node] = true;
    flow::walk<flow::Direction::forward>(graph, {0}, [&](flow::EdgeId edge, flow::NodeId to) {
        if (!analysis_.data().passable(edge)) return flow::Step::refuse;
        reached[to] = true;
        return ends[to] ? flow::Step::end : flow::Step::go_on;
    });
    for (const flow::NodeId node : reach.excluded) reached[node] = false;
    return reached;
}

bool WithoutAssignment::leads_to(Variable variable, flow::NodeId node) {
    Reach& reach = reach_[variable];
    if (reach.nodes.empty()) reach.nodes = reach_of(variable, reach);
    return reach.nodes[node];
}

void WithoutAssignment::exclude(Variable variable, flow::NodeId node) {
    Reach& reach = reach_[variable];
    reach.excluded.push_back(node);
    reach.nodes.clear();
}

std::vector<const dataflow::Store*> last_stores_before(const ProgramAnalysis& analysis, Variable variable,
                                                       const dataflow::Loop& loop) {
    const flow::Graph& graph = analysis.graph();
    std::vector<const dataflow::Store*> found;
    flow::walk<flow::Direction::backward>(graph, {loop.head}, [&](flow::EdgeId edge, flow::NodeId from) {
        if (loop.holds(from) || !analysis.data().passable(edge)) return flow::Step::refuse;
        const dataflow::Store* last = nullptr;
        for (const dataflow::Store& store : analysis.facts().in<dataflow::Store>(from))
            if (store.variable == variable) last = &store;
        if (last != nullptr) found.push_back(last);
        return last == nullptr ? flow::Step::go_on : flow::Step::end;
    });
    return found;
}

execution::PathFound path_without_assignment(execution::PathSearch& search, const ProgramAnalysis& analysis,
                                             Variable variable, flow::NodeId node,
                                             std::optional<flow::NodeId> then) {
    const std::vector<flow::NodeId> assigning = nodes_that_may_change(analysis, variable, node);
    if (node != 0 && std::ranges::binary_search(assigning, flow::NodeId{0})) return {};
    std::vector<execution::Leg> legs{{node, assigning}};
    if (then) legs.push_back({*then, {}});
    return search.find(legs);
}

bool can_follow(const ProgramAnalysis& analysis, flow::NodeId first, flow::NodeId then,
                std::span<const flow::NodeId> barred) {
    execution::PathSearch search(analysis);
    const execution::PathFound found =
        search.find(std::array{execution::Leg{first, {}}, execution::Leg{then, barred}});
    return found.path.has_value();
}

execution::PathFound path_on_from(const ProgramAnalysis& analysis, flow::NodeId from, flow::NodeId to) {
    execution::PathSearch search(analysis);
    execution::PathFound found = search.find(std::array{execution::Leg{from, {}}, execution::Leg{to, {}}});
    if (found.path)
        found.path->erase(found.path->begin(),
                          found.path->begin() + static_cast<std::ptrdiff_t>(found.ends.front()));
    return found;
}

} // namespace maclint::queries
