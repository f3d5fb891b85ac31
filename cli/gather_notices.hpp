//! One note for all files of a kind that are not linted.
#pragma once

#include "cli/notice.hpp"

#include <vector>

namespace maclint::cli {

/// Puts one note in place of those of several files of the same kind: two that were found in a folder, four
/// that were named. It says how many they are, names one, and bears the folder that holds all of them.
[[nodiscard]] std::vector<Notice> gather_by_kind(std::vector<Notice> notices);

} // namespace maclint::cli
