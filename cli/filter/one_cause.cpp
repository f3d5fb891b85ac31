//! Owners are looked up by the effect, or the place in the text, that they speak of.
#include "cli/filter/one_cause.hpp"

#include <algorithm>
#include <cstddef>
#include <string_view>
#include <unordered_map>

namespace maclint::cli {
namespace {

/// Equal for causes that are the same.
std::size_t key_of(const Cause& cause) {
    return std::hash<const void*>{}(cause.program) ^ (cause.effect ? *cause.effect : cause.text.begin);
}

} // namespace

void drop_yielding(std::vector<Finding>& findings, const std::function<bool(const Finding&)>& is_on) {
    if (std::ranges::all_of(findings, [](const Finding& finding) { return finding.rule->yields_to.empty(); }))
        return;
    struct Owned {
        const Rule* rule;
        Cause cause;
    };
    std::unordered_multimap<std::size_t, Owned> owned;
    for (const Finding& finding : findings)
        if (is_on(finding)) owned.emplace(key_of(finding.cause), Owned{finding.rule, finding.cause});
    std::erase_if(findings, [&](const Finding& finding) {
        if (finding.rule->yields_to.empty()) return false;
        const auto [first, last] = owned.equal_range(key_of(finding.cause));
        return std::any_of(first, last, [&](const auto& entry) {
            const Owned& owner = entry.second;
            return lists_code(finding.rule->yields_to, owner.rule->code) &&
                   owner.cause.is_same(finding.cause);
        });
    });
}

} // namespace maclint::cli
