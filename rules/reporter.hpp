//! Where a check puts its findings.
#pragma once

#include "rules/finding.hpp"

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace maclint {

/// Takes the findings of one rule.
class Reporter {
  public:
    explicit Reporter(const Rule& rule)
        : rule_(&rule) {}

    /// Adds a finding and gives it back, to be filled with related places, a path or a fix. Where the
    /// thread's Budget is met meanwhile it is not told.
    Finding& report(const Cause& cause, Span span, std::string_view message_id,
                    std::vector<std::string> arguments);
    /// Whether the rule has a message of that name.
    [[nodiscard]] bool has_message(std::string_view id) const;
    /// "alarm 5074", by the control's list of alarms; "an alarm" where that is not known.
    [[nodiscard]] std::string alarm_words(const ProgramFile& file) const;
    /// The number of the alarm that the control raises for such a finding, a message's id or a fault of a
    /// syntax error (Alarm::of); empty: none is known, or not which of several.
    [[nodiscard]] std::string_view alarm_for(const ProgramFile& file, std::string_view trouble) const;
    [[nodiscard]] std::vector<Finding> take();

  private:
    const Rule* rule_;
    std::vector<Finding> findings_;
    std::size_t sure_ = 0; ///< so many were whole before a limit was met
};

} // namespace maclint
