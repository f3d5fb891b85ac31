//! Tests for vacancy that never find it, and what they were for.
#pragma once

#include "analyzer/dataflow/facts/comparison.hpp"
#include "analyzer/dataflow/facts/store.hpp"
#include "analyzer/source/exemption.hpp"
#include "analyzer/workspace/program_analysis.hpp"

#include <optional>
#include <unordered_map>

namespace maclint::rules {

/// By which a test for vacancy may stand where nothing is vacant.
namespace exemptions {
inline constexpr Exemption zero_made_sure;
} // namespace exemptions

/// Whether the test makes no difference: what it guards only sets the tested variable, or the value is a copy
/// of one that was tested before.
[[nodiscard]] bool is_harmless_guard(const ProgramAnalysis& analysis, const dataflow::Comparison& test,
                                     Variable variable);

/// Whether what the test guards only sets the variable to 0, which a calculation makes of a vacant value
/// anyway.
[[nodiscard]] bool sets_zero(const ProgramAnalysis& analysis, const dataflow::Comparison& test,
                             Variable variable);

/// The last assignment to the variable before the node, in the order of the text; nullptr when there is none.
[[nodiscard]] const dataflow::Store* last_store_before(const ProgramAnalysis& analysis, Variable variable,
                                                       flow::NodeId node);

/// The variables to which a program copies what its call gives it.
class KeptArguments {
  public:
    explicit KeptArguments(const ProgramAnalysis& analysis)
        : analysis_(analysis) {}
    /// Another variable to which the value from the call was copied before it was overwritten.
    [[nodiscard]] std::optional<Variable> keeper_of(Variable variable, flow::NodeId before);

  private:
    using FirstCopies = std::unordered_map<dataflow::Key, const dataflow::Store*>; ///< by the copied variable
    [[nodiscard]] FirstCopies find_first_copies() const;

    const ProgramAnalysis& analysis_;
    std::optional<FirstCopies> first_copies_; ///< found when somebody asks
};

} // namespace maclint::rules
