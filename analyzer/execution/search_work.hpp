//! What the searches of a program look at.
#pragma once

#include "analyzer/source/work_limit.hpp"

#include <cstddef>

namespace maclint::execution {

/// Counts assumptions, expressions, variables and ways on that were looked at, for the thread's WorkLimit
/// too.
class SearchWork {
  public:
    /// See WorkLimit.
    bool allows(std::size_t more) {
        done_ += more;
        return WorkLimit::allows(more);
    }
    [[nodiscard]] std::size_t done() const { return done_; }

  private:
    std::size_t done_ = 0;
};

} // namespace maclint::execution
