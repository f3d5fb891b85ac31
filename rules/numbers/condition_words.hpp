//! What is said of a condition that is decided where it stands.
#pragma once

#include "analyzer/dataflow/facts/condition.hpp"
#include "analyzer/queries/conditions/guards_before.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/finding.hpp"
#include "rules/numbers/constant_condition_reasons_finder.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace maclint::rules {

struct ConditionWords {
    Span span;                   ///< of the condition
    std::string_view message_id; ///< of MAC718
    std::string outcome;         ///< "always" or "never"
    std::vector<std::string> arguments;
    std::optional<RelatedLocation> earlier; ///< the test that decides it
};

/// Finds the words for the conditions of one program.
class ConditionMessages {
  public:
    explicit ConditionMessages(const ProgramAnalysis& analysis)
        : analysis_(analysis) {}

    [[nodiscard]] ConditionWords words_for(const dataflow::Condition& condition,
                                           const std::optional<queries::GuardBefore>& guard);

  private:
    const ProgramAnalysis& analysis_;
    std::optional<std::string> untested_; ///< what is said of arguments that nothing tests
};

} // namespace maclint::rules
