//! Looks at what becomes of a value after its read.
#include "analyzer/queries/vacant_uses.hpp"

#include "analyzer/dataflow/facts/store.hpp"
#include "analyzer/queries/feasible_paths.hpp"

#include <algorithm>
#include <set>

namespace maclint::queries {
namespace {

/// Follows the value through the assignments that copy it; `seen` are effects that were looked at before.
bool is_used(const ProgramAnalysis& analysis, const dataflow::Read& read, std::set<EffectId>& seen) {
    using dataflow::Use;
    // In a program that nobody calls no letter can be meant.
    if (read.use == Use::argument)
        return analysis.is_main() && read.value.vacancy == dataflow::Vacancy::vacant;
    if (read.use != Use::copy && read.use != Use::arithmetic) return true;
    const auto stores = analysis.facts().at<dataflow::Store>(read.effect);
    if (stores.size() != 1) return true; // what it is made of is not known one by one
    const dataflow::Store& store = stores.front();
    if (!analysis.liveness().is_live_after(store.effect, store.variable)) return false;
    if (read.use != Use::copy) return true;
    if (!seen.insert(read.effect).second) return false;
    const dataflow::Facts& facts = analysis.facts();
    const auto of_variable = facts.about<dataflow::Read>(store.variable);
    const auto of_value = facts.with<dataflow::Read>(store.value.symbol);
    return std::ranges::any_of(
        of_variable.size() < of_value.size() ? of_variable : of_value, [&](const dataflow::Read* later) {
            return later->variable == store.variable && later->value.symbol == store.value.symbol &&
                   later->use != Use::vacancy_test && is_used(analysis, *later, seen);
        });
}

} // namespace

bool is_used(const ProgramAnalysis& analysis, const dataflow::Read& read) {
    std::set<EffectId> seen;
    return is_used(analysis, read, seen);
}

execution::PathFound path_to_use(execution::PathSearch& search, const ProgramAnalysis& analysis,
                                 const dataflow::Read& read) {
    if (read.use != dataflow::Use::word)
        return path_without_assignment(search, analysis, read.variable, read.node);
    execution::PathFound found;
    for (const flow::Exit& exit : analysis.graph().exits) {
        if (exit.kind == flow::ExitKind::alarm || !analysis.data().reached(exit.node)) continue;
        found = path_without_assignment(search, analysis, read.variable, read.node, exit.node);
        if (!found.path) continue;
        found.path->resize(found.ends.front());
        break;
    }
    return found;
}

} // namespace maclint::queries
