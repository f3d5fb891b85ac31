//! Looks at the edges that close and leave a loop.
#include "analyzer/queries/loops/loop_exits.hpp"

#include "analyzer/dataflow/domain/read_set.hpp"
#include "analyzer/program/block_view.hpp"
#include "analyzer/program/tables.hpp"
#include "analyzer/queries/calls/callers.hpp"
#include "analyzer/semantics/concrete.hpp"
#include "analyzer/source/budget.hpp"

#include <algorithm>
#include <variant>

namespace maclint::queries {
namespace {

bool is_move(const Program& program, const flow::Node& node) {
    if (node.is_run) return moves(program, node.stretch());
    return std::ranges::any_of(program.effects_in(node.effects), [](const Effect& effect) {
        return std::holds_alternative<Motion>(effect.what);
    });
}

/// A loop that neither moves nor computes waits for somebody else: an operator, a robot, another path.
bool waits(const ProgramAnalysis& analysis, const dataflow::Loop& loop) {
    if (!exemptions::wait_for_others.is_on()) return false;
    for (const flow::NodeId node : loop.body) {
        const flow::Node& n = analysis.graph().nodes[node];
        if (is_move(analysis.program(), n)) return false;
        for (const Effect& effect : analysis.program().effects_in(n.effects))
            if (std::holds_alternative<Assign>(effect.what)) return false;
    }
    return true;
}

/// By a return, a program end or whatever else a condition in it leads to.
bool is_left_in_its_body(const ProgramAnalysis& analysis, const dataflow::Loop& loop) {
    return std::ranges::any_of(loop.exit_edges, [&](flow::EdgeId id) {
        return analysis.graph().edges[id].from != loop.head && analysis.data().passable(id);
    });
}

} // namespace

const flow::Region* region_of(const ProgramAnalysis& analysis, const dataflow::Loop& loop) {
    return loop.region ? &analysis.regions().all[*loop.region] : nullptr;
}

std::optional<EffectId> repeated_by(const ProgramAnalysis& analysis, const dataflow::Loop& loop) {
    if (const flow::Region* region = region_of(analysis, loop)) return region->open;
    return analysis.graph().edges[loop.back].jump;
}

Span span_of_repetition(const ProgramAnalysis& analysis, const dataflow::Loop& loop) {
    const auto by = repeated_by(analysis, loop);
    return by ? analysis.program().effects[*by].span : analysis.graph().nodes[loop.latch].part;
}

bool is_endless_by_jumps(const dataflow::Loop& cycle) { return !cycle.region && cycle.exit_edges.empty(); }

bool repeats_whole_program(const ProgramAnalysis& analysis, const dataflow::Loop& cycle) {
    const Program& program = analysis.program();
    const auto& nodes = analysis.graph().nodes;
    if (analysis.is_macro() || knows_callers(analysis) || cycle.latch + 1 >= nodes.size()) return false;
    const auto behind = program.effects_in(nodes[cycle.latch + 1].effects);
    if (behind.empty() || !std::holds_alternative<Return>(behind.front().what)) return false;
    bool moves = false;
    for (flow::NodeId node = 0; node < nodes.size(); ++node) {
        if (!Budget::allows()) return false;
        if (!analysis.data().reached(node) || !is_move(program, nodes[node])) continue;
        if (!cycle.holds(node)) return false;
        moves = true;
    }
    return moves;
}

bool is_in_endless_jumps(const ProgramAnalysis& analysis, const dataflow::Loop& loop) {
    return any_within_budget(analysis.inescapable_cycles(), [&](const dataflow::Loop& cycle) {
        return is_endless_by_jumps(cycle) && cycle.holds(loop.head);
    });
}

std::optional<ExpressionId> condition_never_met(const ProgramAnalysis& analysis, const dataflow::Loop& loop) {
    const bool is_closed = any_within_budget(analysis.inescapable_cycles(), [&](const dataflow::Loop& cycle) {
        return cycle.head == loop.head && !cycle.exit_edges.empty();
    });
    if (!is_closed || loop.exit_edges.empty()) return std::nullopt;
    const auto& condition = analysis.graph().edges[loop.exit_edges.front()].condition;
    if (!condition || !waits(analysis, loop)) return condition;
    const dataflow::ReadSet set = dataflow::variables_of(analysis.program(), *condition);
    const bool own = std::ranges::all_of(set.variables, [&](Variable variable) {
        return analysis.control().spaces[variable.space].scope == Scope::frame;
    });
    return own ? condition : std::nullopt;
}

std::optional<std::vector<Variable>> unchanging_deciders(const ProgramAnalysis& analysis,
                                                         const dataflow::Loop& loop) {
    std::vector<Variable> deciders;
    const bool others_may = loop.has_unknown_effects || waits(analysis, loop);
    const auto can_change = [&](Variable variable) {
        const bool own = analysis.control().spaces[variable.space].scope == Scope::frame;
        return (!own && others_may) || loop.changes.may_change(variable);
    };
    for (const flow::EdgeId id : loop.exit_edges) {
        const auto& condition = analysis.graph().edges[id].condition;
        if (!condition) return std::nullopt;
        const dataflow::ReadSet set = dataflow::variables_of(analysis.program(), *condition);
        if (!set.closed) return std::nullopt;
        for (const Variable variable : set.variables) {
            if (can_change(variable)) return std::nullopt;
            if (std::ranges::find(deciders, variable) == deciders.end()) deciders.push_back(variable);
        }
    }
    return deciders;
}

std::optional<ExpressionId> idle_condition(const ProgramAnalysis& analysis, const dataflow::Loop& loop) {
    if (region_of(analysis, loop) == nullptr || loop.exit_edges.size() < 2) return std::nullopt;
    const auto exit = std::ranges::find_if(loop.exit_edges, [&](flow::EdgeId id) {
        const flow::Edge& edge = analysis.graph().edges[id];
        return edge.from == loop.head && edge.condition && !analysis.data().passable(id) &&
               !analysis.data().reached(edge.to);
    });
    if (exit == loop.exit_edges.end()) return std::nullopt;
    const ExpressionId condition = *analysis.graph().edges[*exit].condition;
    const dataflow::ReadSet set = dataflow::variables_of(analysis.program(), condition);
    const bool stays =
        set.closed && !set.variables.empty() && std::ranges::none_of(set.variables, [&](Variable variable) {
            return loop.changes.may_change(variable);
        });
    return stays && asks_for_less_or_more(analysis.program(), condition) ? std::optional(condition)
                                                                         : std::nullopt;
}

bool is_never_left(const ProgramAnalysis& analysis, const dataflow::Loop& loop) {
    return std::ranges::none_of(loop.exit_edges,
                                [&](flow::EdgeId id) { return analysis.data().passable(id); });
}

bool asks_for_less_or_more(const Program& program, ExpressionId condition) {
    const auto* asks = std::get_if<Apply>(&program.expressions[condition].node);
    return asks != nullptr && semantics::is_order(asks->operation);
}

bool is_loop_condition(const ProgramAnalysis& analysis, const dataflow::Condition& condition) {
    const auto* mark = std::get_if<RegionMark>(&analysis.program().effects[condition.effect].what);
    return mark != nullptr && is_loop(mark->region_kind);
}

bool never_ends(const ProgramAnalysis& analysis, const dataflow::Condition& condition) {
    const dataflow::ReadSet reads = dataflow::variables_of(analysis.program(), condition.expression);
    if (analysis.control().loops_left_by_jump || !reads.closed || !reads.variables.empty()) return false;
    return any_within_budget(analysis.loops(), [&](const dataflow::Loop& loop) {
        const flow::Region* region = region_of(analysis, loop);
        return region != nullptr && region->open == condition.effect && !loop.can_stop &&
               !is_left_in_its_body(analysis, loop);
    });
}

} // namespace maclint::queries
