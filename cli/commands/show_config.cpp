//! What holds for a file is gathered line by line; text and JSON are written from the same lines.
#include "cli/commands/show_config.hpp"

#include "analyzer/dialect/maker_rights.hpp"
#include "analyzer/program/model.hpp"
#include "analyzer/program/own_codes.hpp"
#include "analyzer/source/encoding.hpp"
#include "cli/config/shop_demands.hpp"
#include "cli/engine/read.hpp"
#include "cli/report/json_head.hpp"
#include "cli/text/shown.hpp"
#include "rules/listed.hpp"

#include <algorithm>
#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

namespace maclint::cli {
namespace {

using Json = nlohmann::ordered_json;

/// One thing that holds for a file.
struct Fact {
    std::string_view name;
    std::string value;
    std::string reason = {}; ///< empty: nothing to be said
};

/// Rules that are not as they come, and why.
struct Change {
    std::string reason;
    std::vector<std::string> what; ///< "MAC501 off"
};

struct RuleCounts {
    std::size_t on, all;
};

/// All that holds for a file.
struct FileFacts {
    std::string path;
    std::vector<Fact> facts = {};
    RuleCounts rules = {}, rows = {}; ///< of a file that is linted
    std::vector<Change> changes = {};

    /// Nothing is said where there is no value.
    void add(std::string_view name, std::string value, std::string reason = {}) {
        if (!value.empty()) facts.push_back({name, std::move(value), std::move(reason)});
    }
};

Fact control_fact(const SnapshotFile& file, const ReadFile& read) {
    const ControlModel& control = *read.file->control;
    const NamedControl* named = control_for(*read.dialect, file.settings.controls);
    std::string reason = named != nullptr               ? named->reason
                         : !read.control_reason.empty() ? read.control_reason
                                                        : "assumed for the dialect";
    if (&control != read.control)
        reason += read.control->machine == Machine::mill
                      ? std::string("; the text is written for a lathe")
                      : std::string("; the text is written with G code system ") + control.code_system;
    return {"control", control.name + ", " + control.description, std::move(reason)};
}

/// Nothing where the configuration does not say which functions stop look-ahead.
std::string look_ahead_of(const MachineFunctions& functions) {
    if (!functions.stopping) return "";
    std::vector<std::string> words;
    for (const auto& [first, last] : *functions.stopping) {
        const auto word = [&](int number) { return std::string(functions.address) + std::to_string(number); };
        words.push_back(first == last ? word(first) : word(first) + "-" + word(last));
    }
    const std::string list = words.empty() ? "no others" : rules::listed(words, " and ");
    return "stopped by the words of the language, and " + list;
}

/// "G81 calls O9010, G310; lacks G51"; nothing where nobody tells of codes of the machine.
std::string own_codes_of(const ControlModel& control) {
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
    return text;
}

/// Where that is not the rule: a FANUC counts least increments.
std::string lengths_of(const ControlModel& control) {
    return control.calculator_input ? "without a point in millimetres or inches" : "";
}

/// Nothing where the shop asks nothing of programs.
std::string demands_of(const ControlModel& control) {
    return control.demands == nullptr ? "" : rules::listed(words_of(*control.demands), " and ");
}

/// What is not as it comes, by reason.
class Changes {
  public:
    explicit Changes(const RuleStates& rules)
        : rules_(rules) {
        for (const Rule* rule : all_rules()) add(*rule);
    }

    [[nodiscard]] std::vector<Change> list() const {
        std::vector<Change> all;
        for (const auto& [reason, what] : by_reason_) all.push_back({reason, what});
        return all;
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
        by_reason_[rules_.reason_of(state)].push_back(what);
    }

    const RuleStates& rules_;
    const RuleStates standard_;
    std::map<std::string, std::vector<std::string>> by_reason_;
};

void add_rules(const RuleStates& rules, FileFacts& facts) {
    facts.rules = {static_cast<std::size_t>(std::ranges::count(rules.rules_on(), true)),
                   rules.rules_on().size()};
    facts.rows = {static_cast<std::size_t>(std::ranges::count(rules.rows(), true, &RuleState::on)),
                  rules.rows().size()};
    facts.changes = Changes(rules).list();
}

/// Nothing where all findings count.
void add_vendor(const SnapshotFile& file, const ReadFile& read, FileFacts& facts) {
    constexpr std::string_view name = "vendor code", value = "only errors count";
    if (file.settings.vendor == VendorCode::whole_file)
        facts.add(name, std::string(value), file.settings.configuration->said_in("vendor"));
    if (file.settings.vendor != VendorCode::by_remarks) return;
    const auto programs = programs_with_rights(*read.file);
    if (programs.empty()) return;
    const std::uint32_t line = read.source->position(programs.front().remark.begin).line;
    facts.add(name, std::string(value), "the remark on line " + std::to_string(line));
}

/// ".maclint.json", and what it extends.
void add_configuration(const Configuration* configuration, FileFacts& facts) {
    if (configuration == nullptr) return facts.add("configuration", "none");
    std::vector<std::string> others;
    for (const Source& source : configuration->sources) others.push_back(source.path());
    others.erase(others.begin());
    facts.add("configuration", configuration->path,
              others.empty() ? "" : "it extends " + rules::listed(others, " and "));
}

void add_baseline(const FileSettings& settings, FileFacts& facts) {
    if (settings.baseline.empty()) return;
    const bool is_said = settings.configuration && settings.baseline == settings.configuration->baseline;
    facts.add("baseline", settings.baseline,
              is_said ? settings.configuration->said_in("baseline") : "--baseline");
}

ReadFile read(const SnapshotFile& file, ProgramStore& store) {
    auto opened = open_file(file);
    if (auto* notice = std::get_if<Notice>(&opened)) return ReadFile{.notice = std::move(*notice)};
    auto source = std::make_shared<const Source>(std::get<Source>(std::move(opened)));
    return read_source(
        file, std::move(source),
        file.settings.vendor == VendorCode::by_remarks ? Extent::whole : Extent::names_and_calls, store);
}

FileFacts facts_of(const SnapshotFile& file, const ReadFile& read) {
    FileFacts facts{.path = file.input.path};
    const FileSettings& settings = file.settings;
    add_configuration(settings.configuration.get(), facts);
    if (read.dialect == nullptr) {
        facts.add("dialect", "none, not linted", read.dialect_reason);
        return facts;
    }
    const ControlModel& control = *read.file->control;
    facts.add("dialect", std::string(read.dialect->name), read.dialect_reason);
    facts.facts.push_back(control_fact(file, read));
    facts.add("look-ahead", look_ahead_of(control.functions));
    facts.add("own codes", own_codes_of(control));
    facts.add("axes", control.axes);
    facts.add("lengths", lengths_of(control));
    facts.add("demanded", demands_of(control));
    add_vendor(file, read, facts);
    if (settings.configuration && settings.configuration->complete)
        facts.add("callers", "all are known", settings.configuration->said_in("complete"));
    if (settings.configuration && settings.configuration->known_names)
        facts.add("known names",
                  std::to_string(settings.configuration->known_names->names.size() +
                                 settings.configuration->known_names->beginnings.size()),
                  settings.configuration->said_in("known-names"));
    add_baseline(settings, facts);
    if (settings.configuration && !settings.configuration->words.empty())
        facts.add("words of the shop", std::to_string(settings.configuration->words.size()),
                  settings.configuration->said_in("words"));
    if (settings.configuration && settings.configuration->spacing != SpacingChoice())
        facts.add("spacing", "formatted by choice", settings.configuration->said_in("spacing"));
    facts.add("encoding", std::string(name_of(read.source->stored_encoding())));
    add_rules(*settings.rules, facts);
    return facts;
}

// ---- as text

std::string line(std::string_view name, const std::string& value, const std::string& reason) {
    std::string label(name);
    label.resize(15, ' ');
    return "  " + label + shown(value) + (reason.empty() ? "" : " (" + shown(reason) + ")") + "\n";
}

std::string text_of(const FileFacts& file) {
    std::string out = shown(file.path) + "\n";
    for (const Fact& fact : file.facts) out += line(fact.name, fact.value, fact.reason);
    if (file.rules.all == 0) return out;
    out += line("rules",
                std::to_string(file.rules.on) + " of " + std::to_string(file.rules.all) + " on, " +
                    std::to_string(file.rows.on) + " of " + std::to_string(file.rows.all) + " rows of rules",
                "");
    for (const Change& change : file.changes) {
        std::string list;
        for (const std::string& what : change.what) list.append(list.empty() ? "" : ", ").append(what);
        out += line("", list, change.reason);
    }
    return out;
}

// ---- as JSON

std::string in_utf8(const std::string& text) { return to_utf8(text, detect_encoding(text)); }

Json json_of(const RuleCounts& counts) { return {{"on", counts.on}, {"all", counts.all}}; }

Json json_of(const FileFacts& file) {
    Json out = {{"file", in_utf8(file.path)}};
    for (const Fact& fact : file.facts) {
        out[std::string(fact.name)] = {{"value", in_utf8(fact.value)}};
        if (!fact.reason.empty()) out[std::string(fact.name)]["reason"] = in_utf8(fact.reason);
    }
    if (file.rules.all == 0) return out;
    Json changes = Json::array();
    for (const Change& change : file.changes)
        changes.push_back({{"reason", in_utf8(change.reason)}, {"rules", change.what}});
    out["rules"] = json_of(file.rules);
    out["rows"] = json_of(file.rows);
    out["changes"] = std::move(changes);
    return out;
}

std::string as_json(const std::vector<FileFacts>& files) {
    Json list = Json::array();
    for (const FileFacts& file : files) list.push_back(json_of(file));
    Json out = json_head();
    out["files"] = std::move(list);
    return json_text(out);
}

} // namespace

ShownConfig show_config(const Snapshot& snapshot, ListFormat format) {
    ShownConfig config;
    std::vector<FileFacts> files;
    ProgramStore store(0);
    for (const SnapshotFile& file : snapshot.files) {
        if (!file.input.asked) continue;
        ReadFile found = read(file, store);
        FileFacts facts = facts_of(file, found);
        if (format == ListFormat::json)
            files.push_back(std::move(facts));
        else
            config.text += text_of(facts);
        if (found.notice) config.notices.push_back(*std::move(found.notice));
    }
    if (format == ListFormat::json) config.text = as_json(files);
    return config;
}

} // namespace maclint::cli
