//! Copies of values that are replaced, and whether anything is lost by that.
#pragma once

#include "analyzer/queries/values/dead_stores.hpp"

namespace maclint::rules {

/// `#32=#5001`, which nobody reads, keeps a place; `#576=#572` loses nothing as long as #572 has it still.
/// But in `N10 #551=#20`, `N20 #551=#21`, where jumps lead to both, the end of the first case is missing.
[[nodiscard]] bool is_spare_copy(const ProgramAnalysis& analysis, const queries::DeadStore& dead);

} // namespace maclint::rules
