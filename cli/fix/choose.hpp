//! Which fixes are applied in one round.
#pragma once

#include "cli/filter/apply_suppressions.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

namespace maclint::cli {

enum class FixesWanted : std::uint8_t {
    safe, ///< those that leave what the program does, or make of a refused block what it can only mean
    all,  ///< those too that somebody should look at
};

/// What changes in one file.
struct FileChange {
    std::shared_ptr<const Source> source;
    std::vector<Edit> edits; ///< in the order of the text; none of which touch each other
    std::size_t findings;    ///< in this file that are mended
};

/// The first fix of each finding that counts and is wanted, in the order of reports. One that touches an
/// earlier one, or a file that may not be changed, waits whole; one that inserts what stands there already is
/// left out. Comments that allow nothing go when nothing else is left to fix.
[[nodiscard]] std::vector<FileChange>
choose_fixes(std::span<const FilteredFinding> findings, FixesWanted wanted,
             const std::function<bool(std::string_view path)>& may_change);

/// The fix that a round would take of the finding; nullptr: none.
[[nodiscard]] const Fix* wanted_fix(const Finding& finding, FixesWanted wanted);

} // namespace maclint::cli
