//! Goes from each vacancy test of an argument to the block that its outcome leads to.
#include "rules/variables/argument_unused_default_finder.hpp"

#include "analyzer/dataflow/facts/read.hpp"

#include <algorithm>
#include <optional>
#include <variant>

namespace maclint::rules {
namespace {

using dataflow::Comparison;
using dataflow::Read;
using dataflow::Store;
using dataflow::Use;

bool is_as_passed(const ProgramAnalysis& analysis, const dataflow::Value& value, Variable variable) {
    return analysis.data().table().symbols[value.symbol].is_entry_of(dataflow::key_of(variable));
}

/// The argument that the test asks for, as it was passed.
std::optional<Variable> argument_asked(const ProgramAnalysis& analysis, const Comparison& test) {
    const auto* load = std::get_if<Load>(&analysis.program().expressions[test.left_expression].node);
    const bool asks = test.operation == Operation::is_set || test.operation == Operation::is_vacant;
    if (!asks || load == nullptr || !analysis.program().is_formal(load->variable) ||
        !is_as_passed(analysis, test.left, load->variable))
        return std::nullopt;
    return load->variable;
}

/// Where the test leads if the argument is there, and nothing else does.
std::optional<flow::NodeId> node_for_set(const ProgramAnalysis& analysis, const Comparison& test) {
    const flow::Graph& graph = analysis.graph();
    for (const flow::EdgeId id : graph.out[test.node]) {
        const flow::Edge& edge = graph.edges[id];
        if (edge.condition == test.expression && edge.holds == (test.operation == Operation::is_set) &&
            graph.in[edge.to].size() == 1)
            return edge.to;
    }
    return std::nullopt;
}

/// A number that is no mark of a case: 1 may be one, and 0 where something compares it.
bool is_default(const ProgramAnalysis& analysis, const Store& store) {
    const auto* literal = std::get_if<Literal>(&analysis.program().expressions[store.expression].node);
    const auto is_compared = [](const Read* read) { return read->use == Use::comparison; };
    return literal != nullptr && literal->value != 1 &&
           (literal->value != 0 ||
            std::ranges::none_of(analysis.facts().about<Read>(store.variable), is_compared));
}

/// Whether the program works with the variable, and never with what was passed.
bool works_with_default_only(const ProgramAnalysis& analysis, Variable variable) {
    bool works = false;
    for (const Read* read : analysis.facts().about<Read>(variable)) {
        if (read->use == Use::vacancy_test) continue;
        if (is_as_passed(analysis, read->value, variable)) return false;
        works |= read->use == Use::word || read->use == Use::arithmetic;
    }
    return works;
}

} // namespace

std::vector<ArgumentOverwritten> find_overwritten_arguments(const ProgramAnalysis& analysis) {
    std::vector<ArgumentOverwritten> found;
    if (analysis.is_main()) return found;
    for (const Comparison& test : analysis.facts().all<Comparison>()) {
        const auto variable = argument_asked(analysis, test);
        const auto node = variable ? node_for_set(analysis, test) : std::nullopt;
        if (!node || !Budget::allows()) continue;
        const auto stores = analysis.facts().about<Store>(*variable);
        const auto store = std::ranges::find(stores, *node, &Store::node);
        if (store != stores.end() && is_default(analysis, **store) &&
            works_with_default_only(analysis, *variable))
            found.push_back({&test, *store});
    }
    return found;
}

} // namespace maclint::rules
