//! What is known of each control: for `maclint controls`.
#pragma once

#include "analyzer/program/tables.hpp"
#include "cli/report/plain_page.hpp"

#include <string>

namespace maclint::cli {

/// A line for each control.
[[nodiscard]] std::string plain_controls(std::size_t width);
/// JSON of all controls, or of one with all that it knows.
[[nodiscard]] std::string json_controls();
[[nodiscard]] std::string json_control(const ControlModel& control);

/// The control's limits, codes, modal groups, variables and alarms.
[[nodiscard]] std::string plain_control_page(const ControlModel& control, const PageStyle& style);

} // namespace maclint::cli
