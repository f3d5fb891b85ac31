//! Shared variables that a program sets on one of two ways, and reads behind both.
#pragma once

#include "analyzer/dataflow/facts/read.hpp"
#include "analyzer/dataflow/facts/store.hpp"
#include "analyzer/workspace/program_analysis.hpp"

#include <vector>

namespace maclint::rules {

/// A read of a variable that one of the ways to it has left as it was when the program began.
struct OneWaySet {
    const dataflow::Read* read;
    const dataflow::Store* store; ///< on the way that sets it
    const dataflow::Store*
        sibling;            ///< on the other way, of a variable that both set; nullptr: that sets nothing
    ExpressionId condition; ///< that chooses between them
    std::vector<flow::EdgeId> path; ///< to the read, on the other way
};

/// The first such read of each variable that lives as long as the control is on. Only where both ways set one
/// variable, or the condition asks for a letter that the value is calculated from, and the callers of the
/// program do not set this one.
[[nodiscard]] std::vector<OneWaySet> find_reads_behind_one_way(const ProgramAnalysis& analysis);

} // namespace maclint::rules
