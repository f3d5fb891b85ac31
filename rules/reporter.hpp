//! Where a check puts its findings.
#pragma once

#include "rules/finding.hpp"

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

    /// Adds a finding and gives it back, to be filled with related places, a path or a fix.
    Finding& report(const Cause& cause, Span span, std::string_view message_id,
                    std::vector<std::string> arguments);
    /// Whether the rule has a message of that name.
    [[nodiscard]] bool has_message(std::string_view id) const;
    [[nodiscard]] std::vector<Finding> take() { return std::move(findings_); }

  private:
    const Rule* rule_;
    std::vector<Finding> findings_;
};

} // namespace maclint
