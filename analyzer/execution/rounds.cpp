//! Loops by their heads; where a jump leads into the middle of one, by what the path has passed.
#include "analyzer/execution/rounds.hpp"

#include "analyzer/dataflow/cycles.hpp"
#include "analyzer/dataflow/facts/clobber.hpp"
#include "analyzer/dataflow/facts/store.hpp"
#include "analyzer/flow/walk.hpp"
#include "analyzer/source/budget.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace maclint::execution {
namespace {

/// Whether a loop inside more loops than these is entered from aside is asked anew on each path.
constexpr int most_depth = 16;
/// Cycles are looked for on each path where nodes entered aside, times all nodes, are no more. Beyond that,
/// in jumps without any order, loops are taken for entered at their heads, and some paths are not found.
constexpr std::size_t most_asked = 4'000'000;

/// What is left of the graph when the nodes are taken out; nothing where no edge leads back in it.
std::optional<flow::Adjacency> without(const flow::Graph& graph, const flow::Adjacency& adjacency,
                                       const std::vector<bool>& taken_out) {
    flow::Adjacency left;
    left.reserve(adjacency.size(), graph.edges.size());
    bool leads_back = false;
    for (flow::NodeId node = 0; node < adjacency.size(); ++node) {
        if (!taken_out[node])
            for (const flow::NodeId to : adjacency[node]) {
                if (taken_out[to]) continue;
                leads_back = leads_back || graph.order[to] <= graph.order[node];
                left.add(to);
            }
        left.end_list();
    }
    return leads_back ? std::optional(std::move(left)) : std::nullopt;
}

bool is_fraction(double number) { return std::floor(number) != number; }

/// Whether a division or a fraction stands in the expression.
bool divides(const Program& program, ExpressionId expression) {
    const auto& node = program.expressions[expression].node;
    if (const auto* literal = std::get_if<Literal>(&node)) return is_fraction(literal->value);
    const auto* apply = std::get_if<Apply>(&node);
    return apply != nullptr && (apply->operation == Operation::divide ||
                                std::ranges::any_of(program.operands_of(*apply), [&](ExpressionId operand) {
                                    return divides(program, operand);
                                }));
}

bool makes_fraction(const Program& program, const dataflow::Store& store) {
    if (store.value.integer) return false;
    if (const auto number = store.step ? store.step->amount.constant() : store.value.constant())
        return is_fraction(*number);
    return divides(program, store.expression);
}

/// Sorts them and leaves each once.
void put_in_order(std::vector<Variable>& variables) {
    std::ranges::sort(variables, {}, [](Variable variable) { return dataflow::key_of(variable); });
    const auto twice = std::ranges::unique(variables);
    variables.erase(twice.begin(), twice.end());
}

} // namespace

Rounds::Rounds(const ProgramAnalysis& analysis)
    : analysis_(analysis)
    , graph_(analysis.graph()) {}

const Rounds::Cycle& Rounds::headed_by(flow::NodeId head) {
    const auto [found, fresh] = by_head_.try_emplace(head);
    Cycle& cycle = found->second;
    if (!fresh) return cycle;
    const Budget own = Budget::without_bound(); // the cycle is kept for others who ask
    flow::walk<flow::Direction::backward>(graph_, {head}, [&](flow::EdgeId edge, flow::NodeId from) {
        if (graph_.order[from] < graph_.order[head] || !analysis_.data().passable(edge))
            return flow::Step::refuse;
        cycle.nodes.push_back(from);
        return from == head ? flow::Step::end : flow::Step::go_on;
    });
    std::ranges::sort(cycle.nodes);
    find_changes(cycle, head);
    return cycle;
}

const Rounds::Cycle& Rounds::through(flow::NodeId node) {
    const Budget own = Budget::without_bound(); // the cycle is kept for others who ask; see most_asked
    std::vector<bool> ahead(graph_.nodes.size(), false);
    measured_ += graph_.nodes.size();
    flow::walk<flow::Direction::forward>(graph_, {node}, [&](flow::EdgeId edge, flow::NodeId to) {
        if (!analysis_.data().passable(edge)) return flow::Step::refuse;
        if (passed_[to]) {
            in_the_way_.push_back(to);
            return flow::Step::refuse;
        }
        ahead[to] = true;
        return to == node ? flow::Step::end : flow::Step::go_on;
    });
    std::pair<flow::NodeId, std::vector<flow::NodeId>> key{node, {}};
    std::vector<flow::NodeId>& nodes = key.second;
    flow::walk<flow::Direction::backward>(graph_, {node}, [&](flow::EdgeId edge, flow::NodeId from) {
        if (!ahead[from] || !analysis_.data().passable(edge)) return flow::Step::refuse;
        nodes.push_back(from);
        return from == node ? flow::Step::end : flow::Step::go_on;
    });
    std::ranges::sort(nodes);
    const auto [found, fresh] = by_nodes_.try_emplace(std::move(key));
    Cycle& cycle = found->second;
    if (!fresh) return cycle;
    cycle.nodes = found->first.second;
    find_changes(cycle, node);
    return cycle;
}

bool Rounds::entered_aside(flow::NodeId node) {
    const std::vector<bool>& aside = nesting().entered_aside;
    left_out_ = left_out_ || nesting_->too_many;
    return !aside.empty() && aside[node];
}

std::optional<flow::NodeId> Rounds::head_around(flow::NodeId node) {
    const auto& heads = nesting().head_around;
    return heads.empty() ? std::nullopt : heads[node];
}

const Rounds::Nesting& Rounds::nesting() {
    if (!nesting_) {
        nesting_ = find_nesting();
        const auto count = static_cast<std::size_t>(std::ranges::count(nesting_->entered_aside, true));
        if (count * graph_.nodes.size() > most_asked) {
            nesting_->entered_aside.clear();
            nesting_->too_many = true;
        }
    }
    return *nesting_;
}

/// Loops from the outside in: what is left of a loop without its head are the loops in it.
Rounds::Nesting Rounds::find_nesting() const {
    const auto whole = dataflow::find_cycles(graph_, analysis_.data());
    if (!whole) return {};
    Nesting nesting{std::vector<bool>(graph_.nodes.size(), false),
                    std::vector<std::optional<flow::NodeId>>(graph_.nodes.size())};
    std::vector<bool> is_head(graph_.nodes.size(), false);
    dataflow::Cycles left = *whole;
    for (int depth = 0;; ++depth) {
        const auto loops = loops_of(left);
        if (loops.empty()) return nesting;
        for (const Loop& loop : loops) {
            is_head[loop.head] = true;
            const bool aside = depth == most_depth || is_entered_aside(loop, left.components);
            for (const flow::NodeId node : loop.nodes) {
                if (node == loop.head) continue;
                nesting.head_around[node] = loop.head;
                if (aside) nesting.entered_aside[node] = true;
            }
        }
        auto inner = without(graph_, whole->adjacency, is_head);
        if (!inner || depth == most_depth) return nesting;
        left.adjacency = *std::move(inner);
        left.components = flow::find_components(left.adjacency);
    }
}

/// The parts of the graph in which every node leads to every other.
std::vector<Rounds::Loop> Rounds::loops_of(const dataflow::Cycles& cycles) const {
    std::vector<Loop> loops;
    for (std::size_t each = 0; each < cycles.components.members.size(); ++each) {
        const auto nodes = cycles.components.members[each];
        const auto after_first = cycles.adjacency[nodes.front()];
        if (nodes.size() == 1 && std::ranges::find(after_first, nodes.front()) == after_first.end()) continue;
        loops.push_back({nodes, *std::ranges::min_element(
                                    nodes, {}, [&](flow::NodeId node) { return graph_.order[node]; })});
    }
    return loops;
}

bool Rounds::is_entered_aside(const Loop& loop, const flow::Components& components) const {
    const auto comes_from_elsewhere = [&](flow::EdgeId id) {
        const flow::NodeId from = graph_.edges[id].from;
        return components.of[from] != components.of[loop.head] && analysis_.data().passable(id);
    };
    return std::ranges::any_of(loop.nodes, [&](flow::NodeId node) {
        return node != loop.head && std::ranges::any_of(graph_.in[node], comes_from_elsewhere);
    });
}

const Changes* Rounds::changes_of(const Cycle& cycle, std::span<const flow::NodeId> barred) {
    const auto is_barred = [&](flow::NodeId node) { return std::ranges::binary_search(barred, node); };
    if (!barred.empty()) measured_ += cycle.nodes.size();
    if (cycle.nodes.empty()) return nullptr;
    if (std::ranges::none_of(cycle.nodes, is_barred)) return &cycle.changes;
    left_out_ = left_out_ || is_barred(cycle.changes.at) || leads_around(cycle, barred);
    return nullptr;
}

/// Whether a round passes none of the barred nodes.
bool Rounds::leads_around(const Cycle& cycle, std::span<const flow::NodeId> barred) const {
    const flow::NodeId at = cycle.changes.at;
    bool leads = false;
    flow::walk<flow::Direction::backward>(graph_, {at}, [&](flow::EdgeId edge, flow::NodeId from) {
        if (leads || !analysis_.data().passable(edge) || !std::ranges::binary_search(cycle.nodes, from) ||
            std::ranges::binary_search(barred, from))
            return flow::Step::refuse;
        leads = from == at;
        return leads ? flow::Step::end : flow::Step::go_on;
    });
    return leads;
}

void Rounds::find_changes(Cycle& cycle, flow::NodeId at) {
    Changes& changes = cycle.changes;
    changes.id = static_cast<std::uint32_t>(by_head_.size() + by_nodes_.size());
    changes.at = at;
    measured_ += cycle.nodes.size();
    for (const flow::NodeId node : cycle.nodes) {
        for (const dataflow::Store& store : analysis_.facts().in<dataflow::Store>(node)) {
            changes.variables.push_back(store.variable);
            if (makes_fraction(analysis_.program(), store)) changes.fractions.push_back(store.variable);
        }
        for (const dataflow::Clobber& clobber : analysis_.facts().in<dataflow::Clobber>(node))
            if (clobber.variable)
                changes.variables.push_back(*clobber.variable);
            else
                changes.spaces.push_back(clobber.space);
        changes.machine = changes.machine || acts(analysis_.program(), graph_.nodes[node]);
    }
    put_in_order(changes.variables);
    put_in_order(changes.fractions);
    std::ranges::sort(changes.spaces);
    changes.spaces.erase(std::ranges::unique(changes.spaces).begin(), changes.spaces.end());
}

} // namespace maclint::execution
