//! Which rules and rows hold for a file and how severe they are, and why.
#pragma once

#include "cli/config/rule_words.hpp"
#include "rules/rule.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace maclint::cli {

/// A setting of a rule or a row. Small: there are as many as rows, for every configuration.
struct RuleState {
    bool on;
    std::optional<Severity> severity; ///< when the user chose one; else the finding's own
    std::uint32_t reason;             ///< where it comes from, see RuleStates::reason_of
};

/// A state for each rule and each row. What is said of a rule is said of all its rows; what is said later
/// counts.
class RuleStates {
  public:
    /// Every rule and row as its record says.
    RuleStates();
    /// What was last said of the rule with all of its rows.
    [[nodiscard]] const RuleState& of(const Rule& rule) const { return rules_[index_of(rule)]; }
    [[nodiscard]] const RuleState& of(const RuleRow& row) const { return rows_[row.index]; }
    /// Of the row that found it, or of the rule where that has none.
    [[nodiscard]] const RuleState& of(const Finding& finding) const {
        return finding.row == nullptr ? of(*finding.rule) : of(*finding.row);
    }
    /// Whether somebody has said something of what found it, and it is not as its record says.
    [[nodiscard]] bool is_asked_for(const Finding& finding) const;
    /// Whether it finds anything: a rule with rows does when one of them is on.
    [[nodiscard]] bool is_on(const Rule& rule) const { return on_[index_of(rule)]; }
    /// That of all rules, in the order of all_rules().
    [[nodiscard]] const std::vector<bool>& rules_on() const { return on_; }
    /// In the order of all_rule_rows().
    [[nodiscard]] const std::vector<RuleState>& rows() const { return rows_; }
    /// "on by default", "--ignore", ".maclint.json: ignore".
    [[nodiscard]] const std::string& reason_of(const RuleState& state) const {
        return reasons_[state.reason];
    }

    /// These and no others.
    void select_only(const std::vector<NamedRule>& rules, std::string_view reason);
    void switch_off(const std::vector<NamedRule>& rules, std::string_view reason);
    void set_severity(const std::vector<NamedRule>& rules, Severity severity, std::string_view reason);

    /// Place of a rule in all_rules().
    [[nodiscard]] static std::size_t index_of(const Rule& rule);

  private:
    template<class Change>
    void change(const std::vector<NamedRule>& rules, const Change& apply);
    std::uint32_t add_reason(std::string_view reason);

    std::vector<RuleState> rules_, rows_;
    std::vector<bool> on_;
    std::vector<std::string> reasons_;
};

[[nodiscard]] std::string_view name_of(Severity severity);
[[nodiscard]] std::optional<Severity> severity_named(std::string_view word);

} // namespace maclint::cli
