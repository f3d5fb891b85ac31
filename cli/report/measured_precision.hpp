//! How precise a rule has proved to be: what was read of its findings in real programs.
#pragma once

#include "rules/rule.hpp"

#include <optional>
#include <span>
#include <string_view>

namespace maclint::cli {

/// Findings that somebody read in their programs; none where they are too few to say anything.
struct ReadFindings {
    unsigned correct; ///< right, and worth acting on
    unsigned decided; ///< all but those that no document decides
};

struct MeasuredRule {
    std::string_view code;
    /// The rule's, by the share of its correct findings; nullopt: its author's estimate stands.
    std::optional<Precision> precision;
    ReadFindings alarms; ///< errors and warnings
    ReadFindings notes;
};

/// nullptr where too few findings of the rule with this code were read.
[[nodiscard]] const MeasuredRule* measured(std::string_view code);
/// In the order of their codes.
[[nodiscard]] std::span<const MeasuredRule> all_measured_rules();

} // namespace maclint::cli
