//! Picks structure faults and holds back those that an unreadable block may explain.
#include "rules/structure_faults.hpp"

#include <algorithm>
#include <iterator>

namespace maclint {

std::vector<flow::StructureFault> structure_faults(const ProgramAnalysis& analysis, flow::Imbalance kind) {
    const flow::Structures& structures = analysis.structures();
    const bool needs_partner = kind == flow::Imbalance::never_closed ||
                               kind == flow::Imbalance::never_opened || kind == flow::Imbalance::crossed;
    std::vector<flow::StructureFault> faults;
    if (needs_partner && structures.balance_in_doubt) return faults;
    std::ranges::copy_if(structures.faults, std::back_inserter(faults),
                         [kind](const flow::StructureFault& fault) { return fault.what == kind; });
    return faults;
}

} // namespace maclint
