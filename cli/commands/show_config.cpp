//! One paragraph a file.
#include "cli/commands/show_config.hpp"

#include "analyzer/program/model.hpp"
#include "cli/suggest.hpp"

#include <map>

namespace maclint::cli {
namespace {

std::string line(std::string_view name, const std::string& value) {
    std::string label(name);
    label.resize(15, ' ');
    return "  " + label + value + "\n";
}

std::string with_reason(std::string_view value, const std::string& reason) {
    return shown(value) + (reason.empty() ? "" : " (" + shown(reason) + ")");
}

std::string control_line(const ReadFile& file) {
    const ControlModel& control = *file.file->control;
    const NamedControl* named = control_for(*file.dialect, file.settings.controls);
    std::string reason = named == nullptr ? "assumed for the dialect" : named->reason;
    if (&control != (named == nullptr ? find_control(file.dialect->default_control) : named->control))
        reason += "; the text is written for a lathe";
    return line("control", with_reason(control.name + ", " + control.description, reason));
}

/// Rules whose state is not the one they come with, by reason.
std::string changed_rules(const RuleStates& rules) {
    const RuleStates standard;
    std::map<std::string, std::string> by_reason;
    for (const Rule* rule : all_rules()) {
        const RuleState& state = rules.of(*rule);
        std::string& list = by_reason[state.reason];
        const std::string code(rule->code);
        if (state.on != standard.of(*rule).on)
            list.append(list.empty() ? "" : ", ").append(code).append(state.on ? " on" : " off");
        if (state.severity)
            list.append(list.empty() ? "" : ", ").append(code).append(" ").append(name_of(*state.severity));
    }
    std::string out;
    for (const auto& [reason, list] : by_reason)
        if (!list.empty()) out += line("", std::string(list).append(" (").append(reason).append(")"));
    return out;
}

std::string rules_lines(const RuleStates& rules) {
    std::size_t on = 0;
    for (const RuleState& state : rules.all()) on += state.on ? 1 : 0;
    return line("rules", std::to_string(on) + " of " + std::to_string(rules.all().size()) + " on") +
           changed_rules(rules);
}

} // namespace

std::string show_config(const std::vector<ReadFile>& files) {
    std::string out;
    for (const ReadFile& file : files) {
        if (!file.input.asked) continue;
        out += shown(file.input.path) + "\n";
        const auto& configuration = file.settings.configuration;
        out += line("configuration", configuration ? shown(configuration->path) : "none");
        if (file.dialect == nullptr) {
            out += line("dialect", with_reason("none, not linted", file.dialect_reason));
            continue;
        }
        out += line("dialect", with_reason(file.dialect->name, file.dialect_reason));
        out += control_line(file);
        out += line("encoding", file.file->source->encoding() == Encoding::utf8 ? "utf-8" : "windows-1252");
        out += rules_lines(*file.settings.rules);
    }
    return out;
}

} // namespace maclint::cli
