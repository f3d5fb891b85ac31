//! Gathers the assignments in a loop's body, and what else changes variables there.
#include "analyzer/dataflow/loop_changes.hpp"

#include "analyzer/dataflow/facts/clobber.hpp"
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
        else if (std::ranges::find(spaces_, clobber.space) == spaces_.end())
            spaces_.push_back(clobber.space);
    });
    std::ranges::sort(assigned_);
    std::ranges::sort(clobbered_);
}

bool LoopChanges::assigned(Variable variable) const {
    return std::ranges::binary_search(assigned_, key_of(variable));
}

bool LoopChanges::clobbered(Variable variable) const {
    return std::ranges::find(spaces_, variable.space) != spaces_.end() ||
           std::ranges::binary_search(clobbered_, key_of(variable));
}

} // namespace maclint::dataflow
