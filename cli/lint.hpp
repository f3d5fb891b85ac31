//! From files that were read to judged findings: what the command, the tests and an editor ask for.
#pragma once

#include "analyzer/workspace/workspace.hpp"
#include "cli/filter/apply_suppressions.hpp"
#include "cli/input/read.hpp"
#include "cli/progress.hpp"

#include <memory>
#include <vector>

namespace maclint::cli {

/// Findings and all that they point to.
struct LintResult {
    std::unique_ptr<Workspace> workspace;
    std::vector<std::shared_ptr<const ProgramFile>>
        kept; ///< files outside the workspace that findings point to
    std::vector<FilteredFinding> findings;
};

/// Runs the rules that any file wants over all files as one workspace.
[[nodiscard]] LintResult lint(const std::vector<ReadFile>& files, unsigned jobs, Progress& progress);

} // namespace maclint::cli
