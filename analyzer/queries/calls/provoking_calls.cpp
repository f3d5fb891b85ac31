//! Holds what a call gives against the conditions on a path.
#include "analyzer/queries/calls/provoking_calls.hpp"

#include "analyzer/dataflow/domain/state.hpp"
#include "analyzer/dataflow/facts/comparison.hpp"
#include "analyzer/flow/walk.hpp"
#include "analyzer/program/tables.hpp"
#include "analyzer/queries/calls/callers.hpp"
#include "analyzer/queries/conditions/conditions.hpp"
#include "analyzer/semantics/truth.hpp"

#include <algorithm>
#include <optional>

namespace maclint::queries {
namespace {

using dataflow::Comparison;
using semantics::Truth;

/// What the call gives the variable; nothing where it is computed.
std::optional<semantics::AbstractValue> value_given(const ProgramAnalysis& analysis, const Caller& call,
                                                    Variable variable) {
    const Argument* argument = argument_for(analysis, call, variable);
    if (argument == nullptr) return semantics::of_vacant();
    const auto& expressions = calling_program(analysis, call).program().expressions;
    const auto* literal = std::get_if<Literal>(&expressions[argument->value].node);
    return literal == nullptr ? std::nullopt : std::optional(semantics::of_number(literal->value));
}

/// The argument that a comparison asks for while it is still as the call has given it.
std::optional<Variable> argument_asked_for(const ProgramAnalysis& analysis, const Comparison& comparison) {
    const auto variable = plain_variable(analysis.program(), comparison.left_expression);
    if (!variable) return std::nullopt;
    const dataflow::Symbol& symbol = analysis.data().table().symbols[comparison.left.symbol];
    const bool as_given = symbol.is_entry_of(dataflow::key_of(*variable));
    return as_given && analysis.program().is_formal(*variable) ? variable : std::nullopt;
}

Truth outcome_of(const ProgramAnalysis& analysis, const Comparison& comparison,
                 const semantics::AbstractValue& given) {
    if (semantics::is_vacancy_test(comparison.operation))
        return semantics::test_vacancy(comparison.operation, given);
    if (!comparison.right.constant()) return {};
    return semantics::compare(comparison.operation, given, comparison.right,
                              analysis.control().vacant_equals_zero);
}

/// Whether the call can go on over the edge.
bool allows(const ProgramAnalysis& analysis, const Caller& call, const flow::Edge& edge) {
    if (!edge.condition) return true;
    for (const Comparison& comparison : analysis.facts().in<Comparison>(edge.from)) {
        if (comparison.expression != *edge.condition) continue;
        const auto variable = argument_asked_for(analysis, comparison);
        const auto given = variable ? value_given(analysis, call, *variable) : std::nullopt;
        if (!given) return true;
        const Truth truth = outcome_of(analysis, comparison, *given);
        return edge.holds ? truth.can_hold : truth.can_fail;
    }
    return true;
}

} // namespace

const Caller* call_that_leaves_out(const ProgramAnalysis& analysis, Variable argument,
                                   std::span<const flow::EdgeId> path) {
    if (!analysis.program().is_formal(argument)) return nullptr;
    const auto found = std::ranges::find_if(analysis.callers(), [&](const Caller& call) {
        if (!opens_locals(analysis, call) || argument_for(analysis, call, argument) != nullptr) return false;
        return std::ranges::all_of(
            path, [&](flow::EdgeId edge) { return allows(analysis, call, analysis.graph().edges[edge]); });
    });
    return found == analysis.callers().end() ? nullptr : &*found;
}

std::vector<bool> nodes_reached_by(const ProgramAnalysis& analysis, const Caller& call,
                                   std::span<const flow::NodeId> ends) {
    const flow::Graph& graph = analysis.graph();
    std::vector<bool> reached(graph.nodes.size(), false);
    reached[0] = true;
    if (std::ranges::binary_search(ends, flow::NodeId{0})) return reached;
    flow::walk<flow::Direction::forward>(graph, {0}, [&](flow::EdgeId edge, flow::NodeId to) {
        if (!analysis.data().passable(edge) || !allows(analysis, call, graph.edges[edge]))
            return flow::Step::refuse;
        reached[to] = true;
        return std::ranges::binary_search(ends, to) ? flow::Step::end : flow::Step::go_on;
    });
    return reached;
}

} // namespace maclint::queries
