//! Looks at what the variables of words held before they were assigned last.
#include "rules/modal/saved_value_lost_saves_finder.hpp"

#include "analyzer/dataflow/domain/read_set.hpp"
#include "analyzer/program/tables.hpp"
#include "analyzer/queries/conditions/conditions.hpp"
#include "analyzer/queries/paths/feasible_paths.hpp"
#include "analyzer/source/budget.hpp"

#include <algorithm>
#include <optional>
#include <set>
#include <utility>

namespace maclint::rules {
namespace {

struct Saved {
    queries::CopySource source;
    flow::NodeId node; ///< in which the variable got it
};

std::optional<Saved> saved_by(const ProgramAnalysis& analysis, const dataflow::Store& save) {
    const auto source = queries::copy_source(analysis, save.expression, save.value);
    if (!source || !source->group) return std::nullopt;
    return Saved{*source, save.node};
}

/// Whether the control can come from the assignment to the node while the variable keeps what it stores.
bool reaches(const ProgramAnalysis& analysis, const dataflow::Store& store, flow::NodeId node) {
    std::vector<flow::NodeId> others;
    const auto all = analysis.facts().about<dataflow::Store>(store.variable);
    if (!Budget::allows(all.size())) return false;
    for (const dataflow::Store* other : all)
        if (other->node != store.node && other->node != node) others.push_back(other->node);
    return store.node != node && queries::can_follow(analysis, store.node, node, others);
}

/// The modal value that the variable held just before the assignment, when it was a saved one: in a loop,
/// before its first round.
std::optional<Saved> saved_before(const ProgramAnalysis& analysis, const dataflow::Store& store) {
    if (const dataflow::Store* save = queries::store_of(analysis, store.old))
        return saved_by(analysis, *save);
    for (const dataflow::Store* save : analysis.facts().about<dataflow::Store>(store.variable)) {
        if (!Budget::allows()) break;
        const auto saved = saved_by(analysis, *save);
        if (saved && reaches(analysis, *save, store.node)) return saved;
    }
    return std::nullopt;
}

/// Whether the word would have put the saved value back.
bool would_restore(const ProgramAnalysis& analysis, const dataflow::ModalWrite& write, GroupId saved) {
    return write.stated ? write.group == saved : analysis.control().groups[saved].letter == 'G';
}

/// A new feed may be computed from the saved one; a new G code may not.
bool is_computed_from(const ProgramAnalysis& analysis, const dataflow::Store& store) {
    const dataflow::ReadSet set = dataflow::variables_of(analysis.program(), store.expression);
    return std::ranges::find(set.variables, store.variable) != set.variables.end();
}

using PutBack = std::set<std::pair<dataflow::Key, ExpressionId>>;

/// The saved values that some word has put back, by the variable of the word: they have served already.
PutBack values_put_back(const ProgramAnalysis& analysis) {
    PutBack found;
    for (const dataflow::ModalWrite& write : analysis.facts().all<dataflow::ModalWrite>()) {
        const auto variable = queries::plain_variable(analysis.program(), write.expression);
        if (!variable) continue;
        if (const auto source = queries::copy_source(analysis, write.expression, write.value))
            found.emplace(dataflow::key_of(*variable), source->expression);
    }
    return found;
}

/// The assignment that surely made the value of the word; where several may have, each that does on some
/// path.
std::vector<const dataflow::Store*> stores_for(const ProgramAnalysis& analysis,
                                               const dataflow::ModalWrite& write, Variable variable) {
    std::vector<const dataflow::Store*> stores;
    if (const dataflow::Store* only = queries::store_of(analysis, write.value)) {
        if (only->variable == variable) stores.push_back(only);
        return stores;
    }
    for (const dataflow::Store* store : analysis.facts().about<dataflow::Store>(variable)) {
        if (!Budget::allows()) break;
        if (saved_before(analysis, *store) && reaches(analysis, *store, write.node)) stores.push_back(store);
    }
    return stores;
}

} // namespace

std::vector<OverwrittenSave> overwritten_saves(const ProgramAnalysis& analysis) {
    std::vector<OverwrittenSave> found;
    std::set<const dataflow::Store*> known;
    std::optional<PutBack> put_back; // most programs overwrite none
    for (const dataflow::ModalWrite& write : analysis.facts().all<dataflow::ModalWrite>()) {
        const auto variable = queries::plain_variable(analysis.program(), write.expression);
        if (!variable) continue;
        for (const dataflow::Store* store : stores_for(analysis, write, *variable)) {
            const auto source = queries::copy_source(analysis, store->expression, store->value);
            if (source && source->group) continue; // saved anew
            const auto saved = saved_before(analysis, *store);
            if (!saved || !would_restore(analysis, write, *saved->source.group)) continue;
            if (exemptions::computed_from_the_saved.is_on() && write.stated &&
                is_computed_from(analysis, *store))
                continue;
            if (known.contains(store)) continue;
            if (!put_back) put_back = values_put_back(analysis);
            if (put_back->contains({dataflow::key_of(*variable), saved->source.expression})) continue;
            known.insert(store);
            found.push_back({saved->source, saved->node, store, &write});
        }
    }
    return found;
}

} // namespace maclint::rules
