//! Looks for where the value stands still, and for jumps to the blocks of both stores.
#include "rules/variables/dead_store_copies_finder.hpp"

#include "analyzer/program/tables.hpp"

#include <algorithm>

namespace maclint::rules {
namespace {

bool is_jumped_to(const ProgramAnalysis& analysis, const dataflow::Store& store) {
    const flow::Graph& graph = analysis.graph();
    return std::ranges::any_of(graph.in[store.node],
                               [&](flow::EdgeId id) { return graph.edges[id].kind == flow::EdgeKind::jump; });
}

bool is_case_that_runs_on(const ProgramAnalysis& analysis, const queries::DeadStore& dead) {
    if (dead.may_end || dead.replaced_by.size() != 1) return false;
    const dataflow::Store& next = *dead.replaced_by.front();
    return dead.store->node < next.node && is_jumped_to(analysis, *dead.store) &&
           is_jumped_to(analysis, next);
}

} // namespace

bool is_spare_copy(const ProgramAnalysis& analysis, const queries::DeadStore& dead) {
    const VariableSpace& space = analysis.control().spaces[dead.store->variable.space];
    return (!dead.read_elsewhere || (space.scope != Scope::frame && !dead.source_changes)) &&
           !std::holds_alternative<Apply>(analysis.program().expressions[dead.store->expression].node) &&
           !is_case_that_runs_on(analysis, dead);
}

} // namespace maclint::rules
