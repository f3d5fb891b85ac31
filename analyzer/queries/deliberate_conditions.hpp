//! Why somebody may have meant a condition that never changes.
#pragma once

#include "analyzer/dataflow/domain/read_set.hpp"
#include "analyzer/dataflow/facts/condition.hpp"
#include "analyzer/queries/settings.hpp"
#include "analyzer/workspace/program_analysis.hpp"

#include <map>
#include <string_view>

namespace maclint::queries {

/// Gathered in one pass over the facts of a program.
class DeliberateConditions {
  public:
    explicit DeliberateConditions(const ProgramAnalysis& analysis);

    /// Whether a condition that is always true, or never, may be meant so: numbers that users edit decide it,
    /// it only makes sure of a limit, repeats a test, or tests what other cases left over. Not: one that is
    /// decided by the other parts of it, as #1LT8 OR #1GT6 is, and one after which no block is left to run.
    [[nodiscard]] bool may_be_meant(const dataflow::Condition& condition) const;

  private:
    [[nodiscard]] bool repeats_another(const dataflow::Condition& condition) const;
    [[nodiscard]] bool leaves_nothing_to_run(const dataflow::Condition& condition) const;
    [[nodiscard]] bool does_what_another_does(const dataflow::Condition& condition) const;

    const ProgramAnalysis& analysis_;
    Settings settings_;
    std::map<Label, flow::NodeId> first_tests_; ///< facts are in the order of nodes
    std::map<std::string_view, int> guarded_;   ///< how many conditions guard what reads like this
};

/// Why a condition is decided where it stands.
struct Reason {
    /// A variable that it asks for, and the one number that this is; nothing: an earlier test decides.
    std::optional<Variable> variable;
    double number = 0;
    Span since;                          ///< what set the variable, or the earlier test
    std::optional<ExpressionId> earlier; ///< of the same variable
};

/// Nothing when neither a number nor one earlier test tells why.
[[nodiscard]] std::optional<Reason> reason_for(const ProgramAnalysis& analysis,
                                               const dataflow::Condition& condition);

} // namespace maclint::queries
