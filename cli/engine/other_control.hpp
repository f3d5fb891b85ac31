//! Says once of a program for another control what would otherwise be said of each of its blocks (MAC005).
#pragma once

#include "analyzer/dialect/dialect.hpp"
#include "cli/filter/apply_suppressions.hpp"

#include <vector>

namespace maclint::cli {

/// The finding, or none. Its last argument is filled in by withhold_misread.
[[nodiscard]] std::vector<Finding> other_control(const ProgramFile& file, const Dialect& dialect);

/// Drops all other findings of files of which MAC005 is reported and not allowed, and says how many those
/// are.
[[nodiscard]] std::vector<FilteredFinding> withhold_misread(std::vector<FilteredFinding> findings);

} // namespace maclint::cli
