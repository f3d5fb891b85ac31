//! Which files a report must not be written over.
#pragma once

#include "cli/command_line.hpp"
#include "cli/config/settings.hpp"
#include "cli/input/discover.hpp"
#include "cli/notice.hpp"

#include <optional>
#include <vector>

namespace maclint::cli {

/// Why one of the reports, or the baseline, must not be written: a link of a checked folder leads to its
/// file, or it lies in a `.git`; it is a program, a configuration or, for a report, a baseline, it is named
/// like a program and would be read as one by the next run, or another report goes to the same file.
[[nodiscard]] std::optional<Notice>
refuse_targets(const CheckRequest& request, const std::vector<InputFile>& files, const Settings& settings);

} // namespace maclint::cli
