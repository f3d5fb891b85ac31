//! An analysis that somebody may end before it is done.
#pragma once

#include "analyzer/workspace/workspace.hpp"

#include <memory>
#include <stop_token>
#include <vector>

namespace maclint {

/// As Workspace::analyse; nullptr where somebody has asked to stop. Asked before each program.
[[nodiscard]] std::unique_ptr<Workspace>
analyse_until(const std::stop_token& stop, std::vector<WorkspaceFile> files, const WorkspaceOptions& options);

} // namespace maclint
