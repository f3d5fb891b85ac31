//! Picks region faults and holds back those that an unreadable block may explain.
#include "analyzer/queries/structure/region_faults.hpp"

#include "analyzer/program/tables.hpp"

#include <algorithm>
#include <iterator>
#include <variant>

namespace maclint::queries {
namespace {

/// Loops of all kinds have one close.
RegionKind family_of(RegionKind region_kind) {
    return is_loop(region_kind) ? RegionKind::while_loop : region_kind;
}

bool needs_partner(flow::Imbalance kind) {
    return kind == flow::Imbalance::never_closed || kind == flow::Imbalance::never_opened ||
           kind == flow::Imbalance::crossed;
}

template<class Wanted>
std::vector<flow::RegionFault> pick(const ProgramAnalysis& analysis, RegionKind region_kind,
                                    const Wanted& wanted) {
    const flow::Regions& regions = analysis.regions();
    std::vector<flow::RegionFault> faults;
    std::ranges::copy_if(regions.faults, std::back_inserter(faults), [&](const flow::RegionFault& fault) {
        if (!wanted(fault.what) || (regions.balance_unknown && needs_partner(fault.what))) return false;
        const auto& what = analysis.program().effects[fault.effect].what;
        return family_of(std::get<RegionMark>(what).region_kind) == region_kind;
    });
    return faults;
}

/// THEN, ELSE and ENDIF of an IF that is not there are one fault.
class Strays {
  public:
    explicit Strays(const Program& program)
        : program_(program) {}

    [[nodiscard]] bool is_reported(const flow::RegionFault& fault) {
        using Part = RegionMark::Part;
        const Part part = std::get<RegionMark>(program_.effects[fault.effect].what).part;
        const bool stray = fault.what == flow::Imbalance::never_opened;
        const bool reported = stray && in_branches_;
        if (!stray || part == Part::close) in_branches_ = false;
        if (stray && (part == Part::begin || part == Part::middle)) in_branches_ = true;
        return reported;
    }

  private:
    const Program& program_;
    bool in_branches_ = false;
};

} // namespace

std::vector<flow::RegionFault> numbered_loop_faults(const ProgramAnalysis& analysis, flow::Imbalance kind) {
    return pick(analysis, RegionKind::while_loop, [kind](flow::Imbalance what) { return what == kind; });
}

std::vector<flow::RegionFault> nesting_faults(const ProgramAnalysis& analysis, RegionKind region_kind) {
    if (is_loop(region_kind) && analysis.control().has(Capability::loop_numbers)) return {};
    auto faults = pick(analysis, family_of(region_kind), [](flow::Imbalance) { return true; });
    Strays strays(analysis.program());
    std::erase_if(faults, [&](const flow::RegionFault& fault) { return strays.is_reported(fault); });
    return faults;
}

} // namespace maclint::queries
