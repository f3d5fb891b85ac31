//! Shared variables that a program sets in some cases of a decision, and reads in others.
#pragma once

#include "analyzer/dataflow/facts/read.hpp"
#include "analyzer/workspace/program_analysis.hpp"

#include <vector>

namespace maclint::rules {

/// A read of a variable that still holds what was in it when the program began.
struct StaleRead {
    const dataflow::Read* read;
    ExpressionId subject;              ///< what decides: #4012
    std::vector<ExpressionId> set_for; ///< the numbers for which the program sets the variable
    ExpressionId missing;              ///< another number that the program asks for
    std::vector<flow::EdgeId> path;    ///< to the read, over the test for that number
};

/// The first such read of each variable that lives as long as the control is on. Only where the program sets
/// it for two numbers at least, asks for a third, and its callers do not set it.
[[nodiscard]] std::vector<StaleRead> find_stale_reads(const ProgramAnalysis& analysis);

/// Where the program stores in the variable, or something may change it: nodes, sorted.
[[nodiscard]] std::vector<flow::NodeId> nodes_that_set(const ProgramAnalysis& analysis, Variable variable);

/// The first reads of the variable that take its value, in the order of nodes.
[[nodiscard]] std::vector<const dataflow::Read*> first_reads(const ProgramAnalysis& analysis,
                                                             Variable variable);

/// Whether a caller sets the variable, or something that it calls besides this program may; so may callers
/// that are too many to be asked.
[[nodiscard]] bool callers_set(const ProgramAnalysis& analysis, Variable variable);

} // namespace maclint::rules
