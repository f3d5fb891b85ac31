//! Gathers the assignments in a loop's body, and what else changes variables there.
#include "analyzer/dataflow/loop_changes.hpp"

#include "analyzer/dataflow/facts/store.hpp"
#include "analyzer/dataflow/loops.hpp"

#include <algorithm>

namespace maclint::dataflow {

LoopChanges::LoopChanges(const Loop& loop, const Facts& facts) {
    for_each_in_body(loop, facts.all<Store>(),
                     [&](const Store& store) { assigned_.push_back(key_of(store.variable)); });
    for_each_in_body(loop, facts.all<Clobber>(), [&](const Clobber& clobber) {
        if (clobber.variable)
            clobbered_.push_back(key_of(*clobber.variable));
        else if (std::ranges::none_of(spaces_, [&](const Clobber& known) {
                     return known.space == clobber.space && known.spared == clobber.spared;
                 }))
            spaces_.push_back(clobber);
    });
    std::ranges::sort(assigned_);
    std::ranges::sort(clobbered_);
}

bool LoopChanges::assigned(Variable variable) const {
    return std::ranges::binary_search(assigned_, key_of(variable));
}

bool LoopChanges::clobbered(Variable variable) const {
    return std::ranges::any_of(spaces_, [&](const Clobber& space) { return space.may_change(variable); }) ||
           std::ranges::binary_search(clobbered_, key_of(variable));
}

} // namespace maclint::dataflow
