//! What is said of a condition that is decided where it stands.
#pragma once

#include "analyzer/dataflow/facts/condition.hpp"
#include "analyzer/queries/deliberate_conditions.hpp"
#include "analyzer/queries/guards_before.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/finding.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace maclint::rules {

struct ConditionWords {
    std::string_view message_id; ///< of MAC718
    std::vector<std::string> arguments;
    std::optional<RelatedLocation> earlier; ///< the test that decides it
};

/// `outcome` is "always" or "never".
[[nodiscard]] ConditionWords words_for(const ProgramAnalysis& analysis, const dataflow::Condition& condition,
                                       const std::optional<queries::GuardBefore>& guard, std::string outcome);

} // namespace maclint::rules
