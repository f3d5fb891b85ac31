//! From words to rules, and the state of each.
#include "cli/config/selection.hpp"

#include "cli/suggest.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <unordered_map>

namespace maclint::cli {
namespace {

constexpr std::array<std::string_view, 3> severity_names = {"note", "warning", "error"};

bool has_digit(std::string_view text) {
    return std::ranges::any_of(text, [](unsigned char c) { return std::isdigit(c) != 0; });
}

/// "MAC", "MAC3" and "MAC30" are prefixes; "M" and "JUMP" are not.
bool is_prefix(std::string_view word) {
    return word == "MAC" || word == "DIN" ||
           ((word.starts_with("MAC") || word.starts_with("DIN")) && has_digit(word));
}

} // namespace

std::vector<const Rule*> rules_named(std::string_view word) {
    const std::string capitals = in_upper_case(word);
    std::vector<const Rule*> rules;
    if (const Rule* rule = find_rule(word)) {
        rules.push_back(rule);
    } else if (capitals == "ALL") {
        rules.assign(all_rules().begin(), all_rules().end());
    } else if (is_prefix(capitals)) {
        std::ranges::copy_if(all_rules(), std::back_inserter(rules),
                             [&](const Rule* candidate) { return candidate->code.starts_with(capitals); });
    }
    return rules;
}

std::vector<const Rule*> rules_meant(std::string_view word) {
    std::vector<const Rule*> rules = rules_named(word);
    if (!rules.empty() || word.empty()) return rules;
    const std::string part = in_lower_case(word);
    const bool is_number = part.find_first_not_of("0123456789") == std::string::npos;
    std::ranges::copy_if(all_rules(), std::back_inserter(rules), [&](const Rule* rule) {
        constexpr std::size_t letters = 3; // of a code
        return is_number ? rule->code.substr(letters).starts_with(part)
                         : rule->name.find(part) != std::string_view::npos;
    });
    return rules;
}

const std::vector<std::string>& rule_words() {
    static const std::vector<std::string> words = [] {
        std::vector<std::string> all;
        for (const Rule* rule : all_rules())
            all.insert(all.end(), {std::string(rule->code), std::string(rule->name)});
        return all;
    }();
    return words;
}

RuleStates::RuleStates() {
    for (const Rule* rule : all_rules())
        states_.push_back(
            {rule->on_by_default, std::nullopt, rule->on_by_default ? "on by default" : "off by default"});
}

void RuleStates::select_only(const std::vector<const Rule*>& rules, std::string_view reason) {
    for (RuleState& state : states_) {
        state.on = false;
        state.reason = reason;
    }
    for (const Rule* rule : rules) states_[index_of(*rule)].on = true;
}

void RuleStates::switch_off(const std::vector<const Rule*>& rules, std::string_view reason) {
    for (const Rule* rule : rules) {
        RuleState& state = states_[index_of(*rule)];
        state.on = false;
        state.reason = reason;
    }
}

void RuleStates::set_severity(const std::vector<const Rule*>& rules, Severity severity,
                              std::string_view reason) {
    for (const Rule* rule : rules) {
        RuleState& state = states_[index_of(*rule)];
        state.severity = severity;
        state.reason = reason;
    }
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
