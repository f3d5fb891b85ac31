//! Reports of so many findings that somebody has to choose.
#pragma once

#include "cli/report/report.hpp"

#include <cstddef>

namespace maclint::cli {

/// Findings that a terminal gets when nobody asks for more or fewer.
inline constexpr std::size_t most_on_terminal = 100;

/// Leaves at most so many findings, the most severe and of those the first ones, in their order; the others
/// are not shown. Suppressed ones stay.
void limit(Report& report, std::size_t most);

/// What a terminal is to show: when there are too many findings the most severe ones, errors first.
void fit_terminal(Report& report);

} // namespace maclint::cli
