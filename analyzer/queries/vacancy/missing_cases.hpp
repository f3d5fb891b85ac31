//! In which cases a variable is set before it is read, where there are others.
#pragma once

#include "analyzer/workspace/program_analysis.hpp"

#include <span>
#include <vector>

namespace maclint::queries {

/// The tests on a path around all assignments of which the other outcome leads to one.
struct MissingCase {
    std::vector<ExpressionId> subjects; ///< what is tested: #4120, #1; each once
    /// Literals, smallest first: the variable is set where the only subject is one of them. None: it depends
    /// on more than that.
    std::vector<ExpressionId> numbers;
};

/// `path` leads from the program's start to the node of the read over no assignment to the variable.
[[nodiscard]] MissingCase missing_case_on(const ProgramAnalysis& analysis, std::span<const flow::EdgeId> path,
                                          Variable variable, flow::NodeId read);

/// Whether all that decides in one case decides in the other, too.
[[nodiscard]] bool is_same_case(const Program& program, const MissingCase& a, const MissingCase& b);

} // namespace maclint::queries
