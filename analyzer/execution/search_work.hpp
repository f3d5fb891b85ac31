//! What the searches of a program look at.
#pragma once

#include "analyzer/source/budget.hpp"

#include <cstddef>

namespace maclint::execution {

/// Counts assumptions, expressions, variables and ways on that were looked at, for the thread's Budget
/// too.
class SearchWork {
  public:
    /// See Budget.
    bool allows(std::size_t more) {
        done_ += more;
        return Budget::allows(more);
    }
    [[nodiscard]] std::size_t done() const { return done_; }

  private:
    std::size_t done_ = 0;
};

} // namespace maclint::execution
