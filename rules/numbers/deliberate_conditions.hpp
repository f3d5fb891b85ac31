//! Why somebody may have meant a condition that never changes.
#pragma once

#include "analyzer/dataflow/conditions.hpp"
#include "analyzer/dataflow/facts/condition.hpp"
#include "analyzer/workspace/program_analysis.hpp"

#include <cstddef>
#include <cstdint>
#include <map>
#include <unordered_map>

namespace maclint::rules {

/// Gathered in one pass over the facts of a program.
class DeliberateConditions {
  public:
    explicit DeliberateConditions(const ProgramAnalysis& analysis);

    /// Everything that is read is set at most once, or a number that users edit decides.
    [[nodiscard]] bool depends_on_settings(const dataflow::ReadSet& reads) const;
    /// A number that users edit in the program's head decides.
    [[nodiscard]] bool reads_setting(const dataflow::ReadSet& reads) const;
    /// An earlier test sends to the same place: the second is not needed, but does no harm.
    [[nodiscard]] bool repeats_another(const dataflow::Condition& condition) const;

  private:
    struct Assigned {
        std::size_t count = 0;
        bool literal = true;
    };
    [[nodiscard]] Assigned assigned(Variable variable) const;

    const Program& program_;
    std::unordered_map<dataflow::Key, Assigned> assigned_;
    std::map<Label, flow::NodeId> first_tests_; ///< facts are in the order of nodes
};

} // namespace maclint::rules
