//! Looks through the records of all rules.
#include "rules/exemption.hpp"

#include "rules/rule.hpp"

#include <algorithm>

namespace maclint {

const RuleExemption& NamedExemption::record() const { return rule->exemptions[index]; }

std::string NamedExemption::name() const {
    return std::string(rule->code) + "/" + std::string(record().name);
}

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
        if ((finding.withheld >> i & 1U) != 0) by.push_back({finding.rule, i});
    return by;
}

} // namespace maclint
