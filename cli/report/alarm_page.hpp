//! Alarms and the rules that find what brings them: for `explain` and the documentation.
#pragma once

#include "cli/report/plain_page.hpp"
#include "rules/alarms/alarm.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace maclint::cli {

/// The alarms that a word may mean: "128", "078", "PS0078", "alarm 78", "P/S 78". `list`: of that one alone;
/// empty: of all.
[[nodiscard]] std::vector<const ControlAlarm*> alarms_named(std::string_view word, std::string_view list);

/// What brings the alarm, what shows it, which rules find it. `list` as above.
[[nodiscard]] std::string plain_alarm_page(const ControlAlarm& alarm, std::string_view list,
                                           const PageStyle& style);

/// Markdown of all alarms with the rules and rows that find them.
[[nodiscard]] std::string markdown_alarms();

/// By it the page is known again.
inline constexpr std::string_view alarms_mark =
    "Made from the table of alarms, the rules and their rows by `maclint rules --write-alarms`.";

} // namespace maclint::cli
