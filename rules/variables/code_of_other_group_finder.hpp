//! Modal codes that are looked for in another group than theirs.
#pragma once

#include "analyzer/dataflow/facts/comparison.hpp"
#include "analyzer/workspace/program_analysis.hpp"

#include <string>
#include <vector>

namespace maclint::rules {

struct CodeOfOtherGroup {
    const dataflow::Comparison* comparison;
    ExpressionId read; ///< #4008
    GroupId group;     ///< that it reads
    std::string code;  ///< "G40"
    GroupId other;     ///< of the code
    std::string meant; ///< "#4007", which reads that
};

/// Comparisons by EQ or NE of a modal code with a number that is no code of its group, on no machine
/// that the control may stand on, and one of another group.
[[nodiscard]] std::vector<CodeOfOtherGroup> find_codes_of_other_groups(const ProgramAnalysis& analysis);

} // namespace maclint::rules
