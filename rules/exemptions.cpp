//! What is held back is found when all exemptions are off, and lost again when one that holds it is put back.
#include "rules/exemptions.hpp"

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

const std::vector<NamedExemption>& all_exemptions() {
    static const std::vector<NamedExemption> exemptions = [] {
        std::vector<NamedExemption> all;
        for (const Rule* rule : all_rules())
            for (std::size_t i = 0; i < rule->exemptions.size(); ++i) all.push_back({rule, i});
        return all;
    }();
    return exemptions;
}

std::optional<NamedExemption> find_exemption(std::string_view name) {
    const std::size_t slash = std::min(name.find('/'), name.size());
    const Rule* rule = find_rule(name.substr(0, slash));
    if (rule == nullptr) return std::nullopt;
    const std::string wanted = std::string(rule->code) + std::string(name.substr(slash));
    const auto found = std::ranges::find_if(all_exemptions(), [&](const NamedExemption& exemption) {
        return exemption.rule == rule && lists_code(exemption.name(), wanted);
    });
    return found == all_exemptions().end() ? std::nullopt : std::optional(*found);
}

std::vector<NamedExemption> withheld_by(const Finding& finding) {
    std::vector<NamedExemption> by;
    for (std::size_t i = 0; i < finding.rule->exemptions.size(); ++i)
        if ((finding.withheld & bit(i)) != 0) by.push_back({finding.rule, i});
    return by;
}

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
