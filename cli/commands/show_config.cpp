//! One paragraph a file.
#include "cli/commands/show_config.hpp"

#include "analyzer/dialect/maker_rights.hpp"
#include "analyzer/program/model.hpp"
#include "analyzer/program/own_codes.hpp"
#include "cli/config/shop_demands.hpp"
#include "cli/engine/read.hpp"
#include "cli/suggest.hpp"
#include "rules/listed.hpp"

#include <algorithm>
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
    if (&control != read.control)
        reason += read.control->machine == Machine::mill
                      ? std::string("; the text is written for a lathe")
                      : std::string("; the text is written with G code system ") + control.code_system;
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
    const std::string list = words.empty() ? "no others" : rules::listed(words, " and ");
    return line("look-ahead", "stopped by the words of the language, and " + list);
}

/// "G81 calls O9010, G310; lacks G51"; nothing where nobody tells of codes of the machine.
std::string own_codes_line(const ControlModel& control) {
    std::vector<std::string> has, lacks;
    for (const OwnCode& code : control.own_codes) {
        const std::string name = spelled(code);
        if (code.program == not_fitted)
            lacks.push_back(name);
        else
            has.push_back(calls_program(code) ? name + " calls O" + std::to_string(code.program) : name);
    }
    std::string text = rules::listed(has, " and ");
    if (!lacks.empty()) text += (text.empty() ? "lacks " : "; lacks ") + rules::listed(lacks, " and ");
    return text.empty() ? "" : line("own codes", text);
}

/// Nothing where nobody tells which axes the machine has.
std::string axes_line(const ControlModel& control) {
    return control.axes.empty() ? "" : line("axes", control.axes);
}

/// Where that is not the rule: a FANUC counts least increments.
std::string lengths_line(const ControlModel& control) {
    return control.calculator_input ? line("lengths", "without a point in millimetres or inches") : "";
}

/// Nothing where the shop asks nothing of programs.
std::string demands_line(const ControlModel& control) {
    if (control.demands == nullptr) return "";
    const std::vector<std::string> words = words_of(*control.demands);
    return words.empty() ? "" : line("demanded", shown(rules::listed(words, " and ")));
}

/// What is not as it comes, by reason.
class Changes {
  public:
    explicit Changes(const RuleStates& rules)
        : rules_(rules) {
        for (const Rule* rule : all_rules()) add(*rule);
    }

    [[nodiscard]] std::string lines() const {
        std::string out;
        for (const auto& [reason, list] : by_reason_)
            out += line("", std::string(list).append(" (").append(reason).append(")"));
        return out;
    }

  private:
    void add(const Rule& rule) {
        const RuleState& state = rules_.of(rule);
        const std::string code(rule.code);
        if (state.on != standard_.of(rule).on) add(state, code + (state.on ? " on" : " off"));
        if (state.severity) add(state, code + " " + std::string(name_of(*state.severity)));
        if (wakes_rows(rule)) add(state, code + " with all its rows");
        for (const RuleRow& row : rows_of(rule)) add(row, state);
    }

    /// Rows that say something else than their rule, where not both are as they come.
    void add(const RuleRow& row, const RuleState& rule) {
        const RuleState& state = rules_.of(row);
        const bool is_changed = state.on != standard_.of(row).on || rule.on != standard_.of(*row.rule).on;
        if (state.on != rule.on && is_changed) add(state, row.name() + (state.on ? " on" : " off"));
        if (state.severity && state.severity != rule.severity)
            add(state, row.name() + " " + std::string(name_of(*state.severity)));
    }

    /// Whether the rule, which is on by default, was selected with rows that are not.
    [[nodiscard]] bool wakes_rows(const Rule& rule) const {
        return rules_.of(rule).on && standard_.of(rule).on &&
               std::ranges::any_of(rows_of(rule), [&](const RuleRow& row) {
                   return rules_.of(row).on && !standard_.of(row).on;
               });
    }

    void add(const RuleState& state, const std::string& what) {
        std::string& list = by_reason_[rules_.reason_of(state)];
        list.append(list.empty() ? "" : ", ").append(what);
    }

    const RuleStates& rules_;
    const RuleStates standard_;
    std::map<std::string, std::string> by_reason_;
};

std::string rules_lines(const RuleStates& rules) {
    const auto on = std::ranges::count(rules.rules_on(), true);
    const auto rows_on = std::ranges::count(rules.rows(), true, &RuleState::on);
    return line("rules", std::to_string(on) + " of " + std::to_string(rules.rules_on().size()) + " on, " +
                             std::to_string(rows_on) + " of " + std::to_string(rules.rows().size()) +
                             " rows of rules") +
           Changes(rules).lines();
}

/// Nothing where all findings count.
std::string vendor_line(const SnapshotFile& file, const ReadFile& read) {
    const auto withheld = [](const std::string& reason) {
        return line("vendor code", with_reason("only errors count", reason));
    };
    if (file.settings.vendor == VendorCode::whole_file)
        return withheld(shown(file.settings.configuration->path) + ": vendor");
    if (file.settings.vendor == VendorCode::none) return "";
    const auto programs = programs_with_rights(*read.file);
    if (programs.empty()) return "";
    return withheld("the remark on line " +
                    std::to_string(read.source->position(programs.front().remark.begin).line));
}

ReadFile read(const SnapshotFile& file, ProgramStore& store) {
    auto opened = open_file(file);
    if (auto* notice = std::get_if<Notice>(&opened)) return ReadFile{.notice = std::move(*notice)};
    auto source = std::make_shared<const Source>(std::get<Source>(std::move(opened)));
    return read_source(
        file, std::move(source),
        file.settings.vendor == VendorCode::by_remarks ? Extent::whole : Extent::names_and_calls, store);
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
    out += own_codes_line(*read.file->control);
    out += axes_line(*read.file->control);
    out += lengths_line(*read.file->control);
    out += demands_line(*read.file->control);
    out += vendor_line(file, read);
    if (!file.settings.baseline.empty()) out += line("baseline", shown(file.settings.baseline));
    out += line("encoding", std::string(name_of(read.source->stored_encoding())));
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
