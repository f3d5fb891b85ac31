//! Looks configurations up folder by folder and lays command line, configuration and defaults over each
//! other.
#include "cli/config/settings.hpp"

#include "analyzer/source/platform/files.hpp"
#include "analyzer/source/platform/paths.hpp"
#include "cli/suggest.hpp"

#include <algorithm>
#include <filesystem>
#include <utility>

namespace maclint::cli {
namespace {

namespace fs = std::filesystem;

fs::path absolute(const std::string& path) {
    std::error_code ignored;
    return fs::absolute(platform::path_of(path), ignored).lexically_normal();
}

std::vector<const Rule*> rules_of(const std::vector<RuleWord>& words) {
    std::vector<const Rule*> rules;
    for (const RuleWord& word : words) {
        const auto named = rules_named(word.word);
        rules.insert(rules.end(), named.begin(), named.end());
    }
    return rules;
}

std::vector<const Rule*> rules_of(const std::vector<std::string>& words) {
    std::vector<const Rule*> rules;
    for (const std::string& word : words) {
        const auto named = rules_named(word);
        rules.insert(rules.end(), named.begin(), named.end());
    }
    return rules;
}

/// So that what is set last holds: the nearer file's word over that of the file it extends, "MAC501" over
/// "MAC5" within a file.
std::vector<SeverityEntry> farthest_and_widest_first(std::vector<SeverityEntry> entries) {
    std::ranges::stable_sort(entries, [](const SeverityEntry& a, const SeverityEntry& b) {
        if (a.rules.source != b.rules.source) return a.rules.source > b.rules.source;
        return rules_named(a.rules.word).size() > rules_named(b.rules.word).size();
    });
    return entries;
}

} // namespace

const NamedControl* control_for(const Dialect& dialect, const std::vector<NamedControl>& controls) {
    const auto found = std::ranges::find_if(
        controls, [&](const NamedControl& named) { return is_for(*named.control, dialect); });
    return found == controls.end() ? nullptr : &*found;
}

std::optional<std::shared_ptr<const Configuration>> Settings::load(const std::string& path) {
    if (const auto known = by_path_.find(path); known != by_path_.end()) return known->second;
    auto result = load_configuration(path);
    if (auto* notice = std::get_if<Notice>(&result)) {
        notices_.push_back(std::move(*notice));
        return by_path_[path] = std::nullopt;
    }
    return by_path_[path] = std::get<std::shared_ptr<const Configuration>>(result);
}

std::optional<std::shared_ptr<const Configuration>> Settings::for_folder(const std::string& folder) {
    if (overrides_.isolated) return nullptr;
    if (!overrides_.config_path.empty()) return load(overrides_.config_path);
    if (const auto known = by_folder_.find(folder); known != by_folder_.end()) return known->second;
    const fs::path at = absolute(folder);
    if (const auto known = by_folder_.find(platform::text_of(at)); known != by_folder_.end())
        return by_folder_[folder] = known->second;
    const fs::path candidate = at / configuration_name;
    const std::string shown = platform::text_of(candidate.lexically_proximate(absolute(".")));
    const platform::FileKind kind = platform::kind_of(candidate);
    Loaded found = nullptr;
    if (kind == platform::FileKind::regular) {
        found = load(shown);
    } else if (kind != platform::FileKind::missing) {
        notices_.push_back(
            {NoticeKind::configuration, shown,
             "is a folder, a pipe or a link that leads nowhere. Put a configuration in its place, "
             "or remove it."});
        found = std::nullopt;
    } else if (at.has_relative_path()) {
        found = for_folder(platform::text_of(at.parent_path()));
    }
    by_folder_[folder] = found; // as it is written, too: many files stand in it
    return by_folder_[platform::text_of(at)] = found;
}

std::optional<FileSettings> Settings::for_file(const std::string& path) {
    const std::string folder = platform::text_of(platform::path_of(path).parent_path());
    const auto found = for_folder(folder.empty() ? "." : folder);
    if (!found) return std::nullopt;
    FileSettings settings;
    settings.configuration = *found;
    settings.max_file_size = overrides_.max_file_size;
    if (*found) {
        for (const FileEntry& entry : (*found)->files) {
            if (!entry.glob.takes(path)) continue;
            const std::string reason = shown((*found)->path) + ": files '" + shown(entry.glob.pattern) + "'";
            if (!entry.dialect.empty()) {
                settings.dialect = find_dialect(entry.dialect);
                settings.dialect_reason = reason;
            }
            if (!entry.control.empty()) {
                settings.controls.push_back({(*found)->control(entry.control), reason});
            }
        }
        std::ranges::reverse(settings.controls); // the last entry that matches counts most
    }
    if (overrides_.dialect != nullptr) {
        settings.dialect = overrides_.dialect;
        settings.dialect_reason = "--dialect";
    }
    if (!overrides_.control.empty()) {
        const ControlModel* named =
            *found ? (*found)->control(overrides_.control) : find_control(overrides_.control);
        if (named != nullptr) settings.controls.insert(settings.controls.begin(), {named, "--control"});
    }
    settings.rules = rules_for(found->get(), path);
    if (!overrides_.baseline.empty())
        settings.baseline = overrides_.baseline;
    else if (*found && !overrides_.no_baseline)
        settings.baseline = (*found)->baseline;
    settings.complete = overrides_.complete || (*found && (*found)->complete);
    return settings;
}

std::shared_ptr<const RuleStates> Settings::rules_for(const Configuration* configuration,
                                                      const std::string& path) {
    std::vector<bool> ignores;
    if (configuration != nullptr)
        for (const PerFileIgnore& entry : configuration->per_file_ignores)
            ignores.push_back(entry.glob.takes(path));
    auto& known = rule_states_[{configuration, ignores}];
    if (known) return known;
    auto rules = std::make_shared<RuleStates>();
    if (configuration != nullptr) {
        const std::string name = shown(configuration->path);
        if (overrides_.select.empty()) {
            if (configuration->select)
                rules->select_only(rules_of(*configuration->select), name + ": select");
            rules->switch_off(rules_of(configuration->ignore), name + ": ignore");
        }
        for (const auto& [words, severity] : farthest_and_widest_first(configuration->severity))
            rules->set_severity(rules_named(words.word), severity, name + ": severity");
    }
    apply_overrides(*rules);
    for (std::size_t i = 0; i < ignores.size(); ++i) {
        const PerFileIgnore& entry = configuration->per_file_ignores[i];
        if (ignores[i])
            rules->switch_off(rules_of(entry.rules), shown(configuration->path) + ": per-file-ignores '" +
                                                         shown(entry.glob.pattern) + "'");
    }
    return known = rules;
}

void Settings::apply_overrides(RuleStates& rules) const {
    if (!overrides_.select.empty()) rules.select_only(rules_of(overrides_.select), "--select");
    rules.switch_off(rules_of(overrides_.ignore), "--ignore");
    for (const auto& [word, severity] : overrides_.severity)
        rules.set_severity(rules_named(word), severity, "--severity");
}

std::vector<std::shared_ptr<const Configuration>> Settings::configurations() const {
    std::vector<std::shared_ptr<const Configuration>> all;
    for (const auto& [path, loaded] : by_path_)
        if (loaded && *loaded) all.push_back(*loaded);
    return all;
}

std::vector<Notice> Settings::take_notices() { return std::exchange(notices_, {}); }

} // namespace maclint::cli
