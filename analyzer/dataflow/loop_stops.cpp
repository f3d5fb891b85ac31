//! Holds what decides over the callee's alarms against what the loop changes.
#include "analyzer/dataflow/loop_stops.hpp"

#include "analyzer/dataflow/domain/read_set.hpp"
#include "analyzer/flow/walk.hpp"
#include "analyzer/program/tables.hpp"

#include <algorithm>

namespace maclint::dataflow {
namespace {

/// For at most this many nodes it is asked what a round may do before it comes to them.
constexpr std::size_t most_placed = 16;

bool adds_nothing(const Store& store) { return store.step && store.step->amount.constant() == 0.0; }

} // namespace

bool LoopStops::may_stop_later(const CallMade& made) {
    if (!made.may_stop || !made.known) return made.may_stop;
    const StopReasons& reasons = analysis_.callee(made.effect).summary.stop_reasons;
    if (reasons.anything) return true;
    const auto& call = std::get<Call>(program_.effects[made.effect].what);
    const bool shared_frame = program_.control->calls[call.kind].frame == Frame::shared;
    const bool differs_somewhere = std::ranges::any_of(reasons.variables, [&](Variable variable) {
        const VariableSpace& space = program_.control->spaces[variable.space];
        if (space.named) return true; // numbered differently in each program
        if (space.scope == Scope::frame && !shared_frame) return passes_other_numbers(made, variable);
        return differs(variable, made.node, most_assignments);
    });
    return differs_somewhere || !is_made_in_each_round(made, call);
}

/// Whether the program is called in the first round, too. If so, it stops there or never.
bool LoopStops::is_made_in_each_round(const CallMade& made, const Call& call) {
    if (program_.control->calls[call.kind].trigger != CallTrigger::once || !flow::surely_runs(program_, call))
        return false;
    if (!in_each_round_) in_each_round_ = nodes_in_each_round();
    return std::ranges::find(*in_each_round_, made.node) != in_each_round_->end();
}

/// The nodes that every way round the loop passes: the nodes of a shortest way round that no other way jumps
/// over.
std::vector<flow::NodeId> LoopStops::nodes_in_each_round() const {
    const auto stays = [this](flow::EdgeId edge, flow::NodeId to) {
        return loop_.holds(to) && analysis_.passable(edge);
    };
    // By place in the body: programs have thousands of loops.
    std::vector<flow::EdgeId> came_by(loop_.body.size(), loop_.back);
    std::vector<bool> met(loop_.body.size(), false);
    flow::walk<flow::Direction::forward>(graph_, {loop_.head}, [&](flow::EdgeId edge, flow::NodeId to) {
        if (to == loop_.head || !stays(edge, to) || met[in_body(to)]) return flow::Step::refuse;
        met[in_body(to)] = true;
        came_by[in_body(to)] = edge;
        return flow::Step::go_on;
    });
    std::vector<flow::NodeId> way{loop_.latch};
    while (way.back() != loop_.head && met[in_body(way.back())])
        way.push_back(graph_.edges[came_by[in_body(way.back())]].from);
    std::ranges::reverse(way);
    std::vector<std::size_t> place(loop_.body.size(), way.size()); // on the way; others have none
    for (std::size_t i = 0; i < way.size(); ++i) place[in_body(way[i])] = i;

    std::vector<flow::NodeId> in_each{loop_.head};
    std::vector<bool> seen(loop_.body.size(), false);
    std::size_t farthest = 0;
    for (std::size_t i = 0; i < way.size(); ++i) {
        if (i > 0 && farthest == i) in_each.push_back(way[i]);
        flow::walk<flow::Direction::forward>(graph_, {way[i]}, [&](flow::EdgeId edge, flow::NodeId to) {
            if (!stays(edge, to) || seen[in_body(to)]) return flow::Step::refuse;
            const std::size_t at = to == loop_.head ? way.size() : place[in_body(to)];
            const bool on_way = to == loop_.head || at < way.size();
            if (on_way) {
                farthest = std::max(farthest, at);
                return flow::Step::refuse;
            }
            seen[in_body(to)] = true;
            return flow::Step::go_on;
        });
    }
    return in_each;
}

std::size_t LoopStops::in_body(flow::NodeId node) const {
    return static_cast<std::size_t>(std::ranges::lower_bound(loop_.body, node) - loop_.body.begin());
}

/// Whether what the call passes for the variable may be another number in another round. What it leaves out
/// is always vacant.
bool LoopStops::passes_other_numbers(const CallMade& made, Variable variable) {
    const auto& call = std::get<Call>(program_.effects[made.effect].what);
    return std::ranges::any_of(program_.arguments_of(call), [&](const Argument& argument) {
        const auto* letter = std::get_if<Variable>(&argument.given);
        if (letter == nullptr) return true; // only the workspace knows what it means
        return *letter == variable && differs(argument.value, made.node, most_assignments);
    });
}

bool LoopStops::differs(ExpressionId expression, flow::NodeId at, int left) {
    const ReadSet reads = variables_of(program_, expression);
    return !reads.closed || std::ranges::any_of(reads.variables, [&](Variable variable) {
        return differs(variable, at, left);
    });
}

/// Whether the variable may hold another number in another round, at a node of the loop. It does not where
/// each round sets it anew from what does not change.
bool LoopStops::differs(Variable variable, flow::NodeId at, int left) {
    if (!loop_.changes.may_change(variable)) return false;
    if (left == 0 || loop_.changes.clobbered(variable)) return true;
    const auto [known, fresh] = differs_.try_emplace({key_of(variable), at, left}, true); // stays where it is
    if (fresh) known->second = is_made_of_others(variable, at, left);
    return known->second;
}

bool LoopStops::is_made_of_others(Variable variable, flow::NodeId at, int left) {
    const Store* only = nullptr;
    for (const Store* store : analysis_.facts().about<Store>(variable)) {
        if (!loop_.holds(store->node) || adds_nothing(*store)) continue;
        if (only != nullptr) return true;
        only = store;
    }
    return only != nullptr && (!is_always_made(*only, at) || differs(only->expression, only->node, left - 1));
}

/// Whether each round makes the assignment before it comes to the node.
bool LoopStops::is_always_made(const Store& store, flow::NodeId at) {
    const Slice effects = graph_.nodes[store.node].effects;
    const bool without_condition =
        store.effect >= effects.first && store.effect < effects.first + effects.count;
    return without_condition && store.node != at && !comes_before(at, store.node);
}

/// Whether a round may come to the node before it comes to `last`, another node. Also true where too many
/// nodes were asked about.
bool LoopStops::comes_before(flow::NodeId node, flow::NodeId last) {
    if (last == loop_.head) return false;
    if (!before_.contains(last) && before_.size() == most_placed) return true;
    const auto [known, fresh] = before_.try_emplace(last);
    if (!fresh) return known->second[in_body(node)];
    std::vector<bool>& before = known->second;
    before.resize(loop_.body.size());
    before[in_body(loop_.head)] = true;
    flow::walk<flow::Direction::forward>(graph_, {loop_.head}, [&](flow::EdgeId edge, flow::NodeId to) {
        if (to == last || !loop_.holds(to) || !analysis_.passable(edge)) return flow::Step::refuse;
        before[in_body(to)] = true;
        return flow::Step::go_on;
    });
    return before[in_body(node)];
}

} // namespace maclint::dataflow
