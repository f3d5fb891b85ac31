//! Asks what each rule says of itself.
#include "cli/report/speaking_rules.hpp"

#include "cli/report/mentions.hpp"
#include "rules/rule.hpp"

#include <algorithm>
#include <string>

namespace maclint::cli {

void add_speaking_rules(PlainPage& page, std::string_view name, std::span<const ControlModel* const> on) {
    bool is_first = true;
    for (const Rule* rule : all_rules()) {
        if (!mentions_code(rule->summary, name) && !mentions_code(rule->why, name)) continue;
        if (std::ranges::none_of(on,
                                 [&](const ControlModel* control) { return applies_to(*rule, *control); }))
            continue;
        if (is_first) page.add_heading("Rules that speak of it:");
        is_first = false;
        page.add_item(std::string(rule->code) + " " + std::string(rule->name) + ": " +
                      std::string(rule->summary) + ".");
    }
}

} // namespace maclint::cli
