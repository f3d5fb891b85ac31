//! The faults in the pairing of loops, choices and units that a rule may speak of.
#pragma once

#include "analyzer/workspace/program_analysis.hpp"

#include <vector>

namespace maclint::queries {

/// Faults of the kind in loops that numbers pair (Capability::loop_numbers). A missing partner proves nothing
/// in a program with a block that may open or close something and cannot be read: those faults are held back.
[[nodiscard]] std::vector<flow::RegionFault> numbered_loop_faults(const ProgramAnalysis& analysis,
                                                                  flow::Imbalance kind);

/// All faults in the pairing of a construct that pairs by nesting alone; a fault between two constructs is
/// the outer one's, whose close comes too early. Branches that lack the word which opens them are reported
/// once, up to their close. Faults that an unreadable block may explain are held back.
[[nodiscard]] std::vector<flow::RegionFault> nesting_faults(const ProgramAnalysis& analysis,
                                                            RegionKind region_kind);

} // namespace maclint::queries
