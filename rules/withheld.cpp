//! What is held back is found when all exemptions are off, and lost again when one that holds it is put back.
#include "rules/withheld.hpp"

#include <algorithm>
#include <set>
#include <utility>

namespace maclint {
namespace {

constexpr ExemptionBits bit(std::size_t index) { return ExemptionBits{1} << index; }

/// A rule speaks of one place once, in whatever words.
using Place = std::pair<const Source*, std::pair<Offset, Offset>>;
Place place_of(const Finding& finding) {
    return {finding.source.get(), {finding.span.begin, finding.span.end}};
}

std::set<Place> places_of(const std::vector<Finding>& findings) {
    std::set<Place> places;
    for (const Finding& finding : findings)
        if (!finding.is_silent) places.insert(place_of(finding));
    return places;
}

} // namespace

ExemptionBits off_in(const ExemptionChoice& choice, const Rule& rule) {
    ExemptionBits off = 0;
    for (const NamedExemption& exemption : choice.without)
        if (exemption.rule == &rule) off |= bit(exemption.index);
    return off;
}

std::vector<const Exemption*> exemptions_of(const Rule& rule, ExemptionBits chosen) {
    std::vector<const Exemption*> exemptions;
    for (std::size_t i = 0; i < rule.exemptions.size(); ++i)
        if ((chosen & bit(i)) != 0) exemptions.push_back(rule.exemptions[i].exemption);
    return exemptions;
}

std::vector<Finding> withheld_findings(const Rule& rule, ExemptionBits off, const FindWithout& find) {
    ExemptionBits all = off;
    for (std::size_t i = 0; i < rule.exemptions.size(); ++i) all |= bit(i);
    const std::set<Place> told = places_of(find(off));
    std::vector<Finding> withheld = find(all);
    std::erase_if(withheld, [&](const Finding& finding) {
        return finding.is_silent || told.contains(place_of(finding));
    });
    for (std::size_t i = 0; i < rule.exemptions.size() && !withheld.empty(); ++i) {
        if ((off & bit(i)) != 0) continue;
        const std::set<Place> with_it = places_of(find(all & ~bit(i)));
        for (Finding& finding : withheld)
            if (!with_it.contains(place_of(finding))) finding.withheld |= bit(i);
    }
    for (Finding& finding : withheld)
        if (finding.withheld == 0) finding.withheld = all & ~off;
    return withheld;
}

} // namespace maclint
