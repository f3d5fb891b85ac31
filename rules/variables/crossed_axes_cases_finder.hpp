//! Numbers of a work offset in the case that a program keeps for another one.
#pragma once

#include "analyzer/flow/graph.hpp"
#include "analyzer/workspace/program_analysis.hpp"

#include <vector>

namespace maclint::rules {

/// A number of one work offset that stands where the program has asked for another.
struct OffsetOfAnotherCase {
    flow::NodeId node;
    EffectId effect;
    ExpressionId operand; ///< #5261
    Variable meant;       ///< the number of the same axis in the case's own offset: #5221
    double asked;         ///< the code that is asked for: 54
    double taken;         ///< the code to which the number belongs: 56
    EffectId own;         ///< a statement of a case that takes its own
};

/// Cases are told by EQ and NE between the code in force, or a variable that is nothing but a copy of it, and
/// a number. Only where more of the program's cases take their own numbers than do not; a statement that
/// moves numbers from one offset to another takes those of both on purpose. In the order of the nodes.
[[nodiscard]] std::vector<OffsetOfAnotherCase> find_offsets_of_other_cases(const ProgramAnalysis& analysis);

} // namespace maclint::rules
