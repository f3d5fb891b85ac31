//! Rows of statements for two cases, alike but for their numbers.
#pragma once

#include "analyzer/workspace/program_analysis.hpp"

#include <string>
#include <vector>

namespace maclint::rules {

/// A statement that sets the variable of the other case, where the rest of its row sets those of its own.
struct StoreOfAnotherCase {
    EffectId effect; ///< #7003=#7003+#26 beside #7021=… and #7022=…
    std::string own; ///< "#7003"
    std::string meant;
    EffectId sibling; ///< the statement of the other case, which is the same
};

/// Rows of as many assignments each, in cases of which only one is run, either behind labels or each behind
/// an IF that asks one variable for a number. All but one statement of the second differ from those of the
/// first by one distance in the numbers of the machine or of common variables, and that one not at all. In
/// text order.
[[nodiscard]] std::vector<StoreOfAnotherCase> find_stores_of_other_cases(const ProgramAnalysis& analysis);

} // namespace maclint::rules
