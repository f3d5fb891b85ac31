//! Which rules hold for a file and how severe they are, and why.
#pragma once

#include "rules/rule.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace maclint::cli {

/// The rules that a word names: a code, an alias or a name in any case, a prefix of codes ("MAC3"), or ALL.
[[nodiscard]] std::vector<const Rule*> rules_named(std::string_view word);

/// Those, or the rules that somebody may mean by a part of a code or name: "220", "jump".
[[nodiscard]] std::vector<const Rule*> rules_meant(std::string_view word);

/// Codes and names, for guessing what a mistyped word means.
[[nodiscard]] const std::vector<std::string>& rule_words();

/// A setting of one rule and where it comes from.
struct RuleState {
    bool on;
    std::optional<Severity> severity; ///< when the user chose one; else the finding's own
    std::string reason;               ///< "on by default", "--ignore", ".maclint.json: ignore"
};

/// One state a rule, in the order of all_rules().
class RuleStates {
  public:
    /// Every rule as its record says.
    RuleStates();
    [[nodiscard]] const RuleState& of(const Rule& rule) const { return states_[index_of(rule)]; }
    [[nodiscard]] const std::vector<RuleState>& all() const { return states_; }

    /// These rules and no others.
    void select_only(const std::vector<const Rule*>& rules, std::string_view reason);
    void switch_off(const std::vector<const Rule*>& rules, std::string_view reason);
    void set_severity(const std::vector<const Rule*>& rules, Severity severity, std::string_view reason);

    /// Variable of a rule in all_rules().
    [[nodiscard]] static std::size_t index_of(const Rule& rule);

  private:
    std::vector<RuleState> states_;
};

[[nodiscard]] std::string_view name_of(Severity severity);
[[nodiscard]] std::optional<Severity> severity_named(std::string_view word);

} // namespace maclint::cli
