//! Why somebody may have meant a condition that never changes.
#pragma once

#include "analyzer/dataflow/domain/read_set.hpp"
#include "analyzer/dataflow/domain/state.hpp"
#include "analyzer/dataflow/facts/condition.hpp"
#include "analyzer/workspace/program_analysis.hpp"

#include <cstddef>
#include <map>
#include <unordered_map>

namespace maclint::queries {

/// Gathered in one pass over the facts of a program.
class DeliberateConditions {
  public:
    explicit DeliberateConditions(const ProgramAnalysis& analysis);

    /// Whether a condition that is always true, or never, may be meant so: numbers that users edit decide it,
    /// it only makes sure of a limit, repeats a test, or tests what other cases left over. Not: one that is
    /// decided by the other parts of it, as #1LT8 OR #1GT6 is.
    [[nodiscard]] bool may_be_meant(const dataflow::Condition& condition) const;

  private:
    struct Assigned {
        std::size_t count = 0;
        bool literal = true;
    };
    [[nodiscard]] Assigned assigned(Variable variable) const;
    [[nodiscard]] bool depends_on_settings(const dataflow::ReadSet& reads) const;
    [[nodiscard]] bool reads_setting(const dataflow::ReadSet& reads) const;
    [[nodiscard]] bool repeats_another(const dataflow::Condition& condition) const;

    const ProgramAnalysis& analysis_;
    std::unordered_map<dataflow::Key, Assigned> assigned_;
    std::map<Label, flow::NodeId> first_tests_; ///< facts are in the order of nodes
};

} // namespace maclint::queries
