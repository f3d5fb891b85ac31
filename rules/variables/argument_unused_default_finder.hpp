//! Arguments that a program replaces just where they were passed.
#pragma once

#include "analyzer/dataflow/facts/comparison.hpp"
#include "analyzer/dataflow/facts/store.hpp"
#include "analyzer/workspace/program_analysis.hpp"

#include <vector>

namespace maclint::rules {

/// A default that is taken where the argument is there, and not where it is left out.
struct ArgumentOverwritten {
    const dataflow::Comparison* test; ///< #9NE#0
    const dataflow::Store* store;     ///< #9=100.
};

/// Only where nothing else reads what was passed, and the program calculates with the variable or makes a
/// word of it: `IF[#13NE#0]THEN #13=1` makes a mark of an argument, which other tests ask for. 0 and 1 are
/// such marks. In the order of the nodes.
[[nodiscard]] std::vector<ArgumentOverwritten> find_overwritten_arguments(const ProgramAnalysis& analysis);

} // namespace maclint::rules
