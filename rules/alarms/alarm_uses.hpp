//! Which rules, and which rows of the tables of words, raise an alarm.
#pragma once

#include "rules/alarms/alarm.hpp"
#include "rules/words/rule_row.hpp"

#include <span>
#include <string_view>
#include <vector>

namespace maclint {

/// A rule that names the alarm itself, or has rows that do.
struct AlarmUse {
    const Rule* rule;
    std::vector<const RuleRow*> rows; ///< empty: the rule names it itself
};

/// Those that find what brings the alarm of a list, in the order of their codes.
[[nodiscard]] std::span<const AlarmUse> uses_of(std::string_view list, std::string_view number);

/// An alarm by its list and number.
struct AlarmName {
    std::string_view list;
    std::string_view number;
    friend bool operator==(const AlarmName&, const AlarmName&) = default;
};

/// All that a rule names, itself or by its rows, each once: first its own, then by row.
[[nodiscard]] std::vector<AlarmName> alarms_of(const Rule& rule);

} // namespace maclint
