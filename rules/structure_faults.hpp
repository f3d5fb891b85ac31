//! The faults in the pairing of loops that a rule may speak of.
#pragma once

#include "analyzer/workspace/program_analysis.hpp"

#include <vector>

namespace maclint {

/// Faults of the kind. A missing partner proves nothing in a program with a block that may open or close
/// something and cannot be read: those faults are held back.
[[nodiscard]] std::vector<flow::StructureFault> structure_faults(const ProgramAnalysis& analysis,
                                                                 flow::Imbalance kind);

} // namespace maclint
