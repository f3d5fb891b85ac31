//! Looks at what becomes of a value after its read.
#include "analyzer/queries/vacant_uses.hpp"

#include "analyzer/dataflow/facts/store.hpp"

#include <algorithm>
#include <array>
#include <set>

namespace maclint::queries {
namespace {

/// Follows the value through the assignments that copy it; `seen` are effects that were looked at before.
bool is_used(const ProgramAnalysis& analysis, const dataflow::Read& read, std::set<EffectId>& seen) {
    using dataflow::Use;
    if (read.use == Use::argument) return false;
    if (read.use != Use::copy && read.use != Use::arithmetic) return true;
    const auto stores = analysis.facts().at<dataflow::Store>(read.effect);
    if (stores.size() != 1) return true; // what it is made of is not known one by one
    const dataflow::Store& store = stores.front();
    if (!analysis.liveness().is_live_after(store.effect, store.variable)) return false;
    if (read.use != Use::copy) return true;
    if (!seen.insert(read.effect).second) return false;
    return std::ranges::any_of(analysis.facts().all<dataflow::Read>(), [&](const dataflow::Read& later) {
        return later.variable == store.variable && later.value.symbol == store.value.symbol &&
               later.use != Use::vacancy_test && is_used(analysis, later, seen);
    });
}

} // namespace

bool is_used(const ProgramAnalysis& analysis, const dataflow::Read& read) {
    std::set<EffectId> seen;
    return is_used(analysis, read, seen);
}

bool goes_on_after(execution::PathSearch& search, const ProgramAnalysis& analysis,
                   const dataflow::Read& read) {
    if (read.use != dataflow::Use::word) return true;
    return std::ranges::any_of(analysis.graph().exits, [&](const flow::Exit& exit) {
        if (exit.kind == flow::ExitKind::alarm || !analysis.data().reached(exit.node)) return false;
        const std::array legs{execution::Leg{read.node, {}}, execution::Leg{exit.node, {}}};
        const execution::PathFound found = search.find(legs);
        return found.path || found.gave_up;
    });
}

} // namespace maclint::queries
