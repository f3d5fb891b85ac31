//! The state of each rule and row.
#include "cli/config/selection.hpp"

#include "cli/text/letters.hpp"

#include <algorithm>
#include <array>
#include <unordered_map>

namespace maclint::cli {
namespace {

constexpr std::array<std::string_view, 3> severity_names = {"note", "warning", "error"};
enum : std::uint32_t { on_by_default, off_by_default }; // the first reasons

RuleState state_by_default(bool on) { return {on, std::nullopt, on ? on_by_default : off_by_default}; }

} // namespace

RuleStates::RuleStates()
    : reasons_{"on by default", "off by default"} {
    for (const RuleRow& row : all_rule_rows()) rows_.push_back(state_by_default(row.on_by_default()));
    for (const Rule* rule : all_rules()) {
        rules_.push_back(state_by_default(rule->on_by_default));
        const auto rows = rows_of(*rule);
        on_.push_back(rows.empty() ? rule->on_by_default
                                   : std::ranges::any_of(rows, &RuleRow::on_by_default));
    }
}

bool RuleStates::is_asked_for(const Finding& finding) const {
    const RuleState& state = of(finding);
    return state.reason != on_by_default && state.reason != off_by_default;
}

template<class Change>
void RuleStates::change(const std::vector<NamedRule>& rules, const Change& apply) {
    for (const auto& [rule, row] : rules) {
        const std::size_t index = index_of(*rule);
        const auto rows = rows_of(*rule);
        if (row != nullptr) {
            apply(rows_[row->index]);
        } else {
            apply(rules_[index]);
            for (const RuleRow& each : rows) apply(rows_[each.index]);
        }
        on_[index] = rows.empty()
                         ? rules_[index].on
                         : std::ranges::any_of(rows, [&](const RuleRow& each) { return of(each).on; });
    }
}

std::uint32_t RuleStates::add_reason(std::string_view reason) {
    reasons_.emplace_back(reason);
    return static_cast<std::uint32_t>(reasons_.size() - 1);
}

void RuleStates::select_only(const std::vector<NamedRule>& rules, std::string_view reason) {
    const std::uint32_t why = add_reason(reason);
    for (auto* states : {&rules_, &rows_})
        for (RuleState& state : *states) {
            state.on = false;
            state.reason = why;
        }
    on_.assign(on_.size(), false);
    change(rules, [](RuleState& state) { state.on = true; });
}

void RuleStates::switch_off(const std::vector<NamedRule>& rules, std::string_view reason) {
    const std::uint32_t why = add_reason(reason);
    change(rules, [&](RuleState& state) {
        state.on = false;
        state.reason = why;
    });
}

void RuleStates::set_severity(const std::vector<NamedRule>& rules, Severity severity,
                              std::string_view reason) {
    const std::uint32_t why = add_reason(reason);
    change(rules, [&](RuleState& state) {
        state.severity = severity;
        state.reason = why;
    });
}

std::size_t RuleStates::index_of(const Rule& rule) {
    static const std::unordered_map<const Rule*, std::size_t> places = [] {
        std::unordered_map<const Rule*, std::size_t> all;
        for (std::size_t i = 0; i < all_rules().size(); ++i) all.emplace(all_rules()[i], i);
        return all;
    }();
    return places.at(&rule);
}

std::string_view name_of(Severity severity) { return severity_names.at(static_cast<std::size_t>(severity)); }

std::optional<Severity> severity_named(std::string_view word) {
    const auto* const found = std::ranges::find(severity_names, in_lower_case(word));
    if (found == severity_names.end()) return std::nullopt;
    return static_cast<Severity>(found - severity_names.begin());
}

} // namespace maclint::cli
