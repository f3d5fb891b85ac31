//! How long a code is in force, by the modal groups of its control.
#pragma once

#include "analyzer/program/tables.hpp"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace maclint::cli {

/// Lines that tell its group, what cancels it and what else ends it; none where no group has the first of the
/// codes, which say the same.
[[nodiscard]] std::vector<std::string> force_of(const ControlModel& control,
                                                std::span<const std::string_view> codes);

} // namespace maclint::cli
