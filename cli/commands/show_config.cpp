//! One paragraph a file.
#include "cli/commands/show_config.hpp"

#include "analyzer/program/model.hpp"
#include "cli/engine/read.hpp"
#include "cli/suggest.hpp"

#include <map>
#include <string>
#include <vector>

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

std::string control_line(const SnapshotFile& file, const ReadFile& read) {
    const ControlModel& control = *read.file->control;
    const NamedControl* named = control_for(*read.dialect, file.settings.controls);
    std::string reason = named != nullptr               ? named->reason
                         : !read.control_reason.empty() ? read.control_reason
                                                        : "assumed for the dialect";
    if (&control != read.control) reason += "; the text is written for a lathe";
    return line("control", with_reason(control.name + ", " + control.description, reason));
}

/// Nothing where the configuration does not say which functions stop look-ahead.
std::string look_ahead_line(const MachineFunctions& functions) {
    if (!functions.stopping) return "";
    std::vector<std::string> words;
    for (const auto& [first, last] : *functions.stopping) {
        const auto word = [&](int number) { return std::string(functions.address) + std::to_string(number); };
        words.push_back(first == last ? word(first) : word(first) + "-" + word(last));
    }
    const std::string list = words.empty() ? "no others" : enumerate(words);
    return line("look-ahead", "stopped by the words of the language, and " + list);
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

ReadFile read(const SnapshotFile& file, ProgramStore& store) {
    auto opened = open_file(file);
    if (auto* notice = std::get_if<Notice>(&opened)) return ReadFile{.notice = std::move(*notice)};
    auto source = std::make_shared<const Source>(std::get<Source>(std::move(opened)));
    return read_source(file, std::move(source), Extent::names_and_calls, store);
}

std::string paragraph(const SnapshotFile& file, const ReadFile& read) {
    std::string out = shown(file.input.path) + "\n";
    const auto& configuration = file.settings.configuration;
    out += line("configuration", configuration ? shown(configuration->path) : "none");
    if (read.dialect == nullptr)
        return out + line("dialect", with_reason("none, not linted", read.dialect_reason));
    out += line("dialect", with_reason(read.dialect->name, read.dialect_reason));
    out += control_line(file, read);
    out += look_ahead_line(read.file->control->functions);
    if (!file.settings.baseline.empty()) out += line("baseline", shown(file.settings.baseline));
    out += line("encoding", read.source->encoding() == Encoding::utf8 ? "utf-8" : "windows-1252");
    return out + rules_lines(*file.settings.rules);
}

} // namespace

ShownConfig show_config(const Snapshot& snapshot) {
    ShownConfig config;
    ProgramStore store(0);
    for (const SnapshotFile& file : snapshot.files) {
        if (!file.input.asked) continue;
        ReadFile found = read(file, store);
        config.text += paragraph(file, found);
        if (found.notice) config.notices.push_back(*std::move(found.notice));
    }
    return config;
}

} // namespace maclint::cli
