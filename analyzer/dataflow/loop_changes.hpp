//! What a loop changes.
#pragma once

#include "analyzer/dataflow/domain/state.hpp"
#include "analyzer/dataflow/facts/clobber.hpp"
#include "analyzer/dataflow/facts/facts.hpp"

#include <vector>

namespace maclint::dataflow {

struct Loop;

/// Every variable that a loop's body may change, in whatever way.
class LoopChanges {
  public:
    LoopChanges() = default;
    LoopChanges(const Loop& loop, const Facts& facts);
    [[nodiscard]] bool may_change(Variable variable) const {
        return assigned(variable) || clobbered(variable);
    }
    [[nodiscard]] bool assigned(Variable variable) const;
    /// By something that is no assignment: a call, a store through an index.
    [[nodiscard]] bool clobbered(Variable variable) const;

  private:
    std::vector<Key> assigned_, clobbered_; ///< sorted
    std::vector<Clobber> spaces_;           ///< that change anything of a space
};

} // namespace maclint::dataflow
