//! From files that were read to judged findings: what the command, the tests and an editor ask for.
#pragma once

#include "cli/filter/apply_suppressions.hpp"
#include "cli/input/read.hpp"
#include "cli/progress.hpp"

#include <vector>

namespace maclint::cli {

struct LintResult {
    std::vector<FilteredFinding> findings; ///< in the order of reports
};

/// Runs the rules that any file wants over all files as one workspace.
[[nodiscard]] LintResult lint(const std::vector<ReadFile>& files, unsigned jobs, Progress& progress);

} // namespace maclint::cli
