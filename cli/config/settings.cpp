//! Looks configurations up folder by folder and lays command line, configuration and defaults over each
//! other.
#include "cli/config/settings.hpp"

#include "analyzer/source/platform/files.hpp"
#include "analyzer/source/platform/paths.hpp"
#include "analyzer/source/read.hpp"
#include "cli/input/repository.hpp"
#include "cli/text/shown.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <ranges>
#include <unordered_map>
#include <utility>

namespace maclint::cli {
namespace {

namespace fs = std::filesystem;

/// Absolute and normal, "." and "folder/" like the folder's name: each folder is known once.
fs::path folder_named(const std::string& path) {
    std::error_code ignored;
    const fs::path whole = fs::absolute(platform::path_of(path), ignored).lexically_normal();
    return whole.has_filename() || !whole.has_relative_path() ? whole : whole.parent_path();
}

void append(std::vector<NamedRule>& rules, std::string_view word) {
    const auto named = rules_named(word);
    rules.insert(rules.end(), named.begin(), named.end());
}

std::vector<NamedRule> rules_of(const std::vector<RuleWord>& words) {
    std::vector<NamedRule> rules;
    for (const RuleWord& word : words) append(rules, word.word);
    return rules;
}

std::vector<NamedRule> rules_of(const std::vector<std::string>& words) {
    std::vector<NamedRule> rules;
    for (const std::string& word : words) append(rules, word);
    return rules;
}

/// How much a word names: a rule counts for more than any of its rows.
std::size_t width_of(std::string_view word) {
    std::size_t width = 0;
    for (const NamedRule& named : rules_named(word)) {
        constexpr std::size_t itself = 1;
        width += itself + (named.row == nullptr ? rows_of(*named.rule).size() : 0);
    }
    return width;
}

/// So that what is set last holds: the nearer file's word over that of the file it extends, "MAC501" over
/// "MAC5" within a file, and "MAC523/G83.Q" over "MAC523".
std::vector<SeverityEntry> farthest_and_widest_first(std::vector<SeverityEntry> entries) {
    std::unordered_map<std::string, std::size_t> widths;
    for (const SeverityEntry& entry : entries)
        widths.try_emplace(entry.rules.word, width_of(entry.rules.word));
    std::ranges::stable_sort(entries, [&](const SeverityEntry& a, const SeverityEntry& b) {
        if (a.rules.source != b.rules.source) return a.rules.source > b.rules.source;
        return widths.at(a.rules.word) > widths.at(b.rules.word);
    });
    return entries;
}

} // namespace

const NamedControl* control_for(const Dialect& dialect, const std::vector<NamedControl>& controls) {
    const auto found = std::ranges::find_if(
        controls, [&](const NamedControl& named) { return is_for(*named.control, dialect); });
    return found == controls.end() ? nullptr : &*found;
}

std::optional<std::shared_ptr<const Configuration>> Settings::load(const std::string& path,
                                                                   const Reach& reach) {
    if (const auto known = by_path_.find(path); known != by_path_.end()) return known->second;
    auto result = load_configuration(path, reach);
    if (auto* notice = std::get_if<Notice>(&result)) {
        notices_.push_back(std::move(*notice));
        return by_path_[path] = std::nullopt;
    }
    const auto& loaded = std::get<std::shared_ptr<const Configuration>>(result);
    if (reach.is_bounded())
        for (const Source& source : loaded->sources) note_owner(source.path());
    return by_path_[path] = loaded;
}

void Settings::note_owner(const std::string& path) {
    const auto owners = platform::ownership_of(platform::path_of(path));
    if (owners && is_of_stranger(*owners))
        note_once(path,
                  "this configuration belongs to another user. Look at what it says, or leave it out "
                  "with --isolated.",
                  NoticeKind::origin);
}

/// Where the folder is a repository of its own. One within another, such as a submodule, is no stranger to
/// what that one says.
void Settings::note_above(const Configuration& configuration, const fs::path& folder) {
    if (!is_repository(folder) || repository_around(platform::path_of(configuration.folder))) return;
    note_once(configuration.path,
              "this configuration lies above the repository of the programs that it holds "
              "for. Put one into the repository, or leave it out with --isolated.",
              NoticeKind::origin);
}

void Settings::note_once(const std::string& path, const std::string& message, NoticeKind kind) {
    if (noted_.emplace(path, message).second) notices_.push_back({kind, path, message});
}

void Settings::note_other_names(const fs::path& folder, const std::string& shown) {
    // Without its dot, or as an editor of Windows stores it.
    static constexpr std::array<std::string_view, 4> names = {"maclint.json", ".maclint.jsonc",
                                                              ".maclint.json.txt", "maclint.json.txt"};
    for (const std::string_view name : names) {
        const fs::path file = folder / name;
        if (platform::kind_of(file) != platform::FileKind::regular || platform::link_target(file)) continue;
        const auto read = read_regular_file(platform::text_of(file), configuration_limit);
        const auto* source = std::get_if<Source>(&read);
        if (source == nullptr || !looks_like_configuration(source->bytes())) continue;
        const std::string path = platform::text_of(
            platform::path_of(shown).replace_filename(platform::path_of(std::string(name))));
        note_once(path,
                  "is not read: a configuration is named " + std::string(configuration_name) + ". Rename it.",
                  NoticeKind::idle_setting);
    }
}

std::optional<Notice> Settings::refuse_link(const fs::path& folder, const std::string& shown) const {
    const fs::path link = folder / configuration_name;
    if (!platform::link_target(link)) return std::nullopt;
    const auto objection = Reach::of_folder(folder, own_).objection("", link);
    if (!objection) return std::nullopt;
    return Notice{NoticeKind::configuration, shown,
                  "is a link to a file that " + *objection +
                      ". If you trust it, name that file with --config."};
}

std::optional<std::shared_ptr<const Configuration>> Settings::for_folder(const std::string& folder) {
    if (overrides_.isolated) return nullptr;
    if (!overrides_.config_path.empty()) return load(overrides_.config_path, Reach::of_command_line());
    if (const auto known = by_folder_.find(folder); known != by_folder_.end()) return known->second;
    const fs::path at = folder_named(folder);
    if (const auto known = by_folder_.find(platform::text_of(at)); known != by_folder_.end())
        return by_folder_[folder] = known->second;
    const std::string shown =
        platform::text_of((at / configuration_name).lexically_proximate(folder_named(".")));
    const Loaded found = in_folder(at, shown);
    by_folder_[folder] = found; // as it is written, too: many files stand in it
    return by_folder_[platform::text_of(at)] = found;
}

std::optional<std::shared_ptr<const Configuration>> Settings::in_folder(const fs::path& folder,
                                                                        const std::string& shown) {
    if (auto refused = refuse_link(folder, shown)) {
        notices_.push_back(*std::move(refused));
        return std::nullopt;
    }
    switch (platform::kind_of(folder / configuration_name)) {
    case platform::FileKind::regular: return load(shown, Reach::of_folder(folder, own_));
    case platform::FileKind::missing: note_other_names(folder, shown); break;
    default:
        notices_.push_back(
            {NoticeKind::configuration, shown,
             "is a folder, a pipe or a link that leads nowhere. Put a configuration in its place, "
             "or remove it."});
        return std::nullopt;
    }
    if (!folder.has_relative_path()) return nullptr;
    auto above = for_folder(platform::text_of(folder.parent_path()));
    if (above && *above) note_above(**above, folder);
    return above;
}

/// What the entries of "files" say: the last one that matches counts most, of controls for each language.
void Settings::say_of_file(const Configuration& configuration, const std::string& path,
                           FileSettings& settings) {
    const auto entries = configuration.files_by_glob.that_take(path);
    for (const std::size_t i : std::views::reverse(entries)) {
        const FileEntry& entry = configuration.files[i];
        const auto reason = [&] {
            return configuration.said_in(entry.source, "files '" + shown(entry.glob.pattern) + "'");
        };
        if (!entry.dialect.empty() && settings.dialect_reason.empty()) {
            settings.dialect = find_dialect(entry.dialect);
            settings.dialect_reason = reason();
        }
        if (entry.control.empty()) continue;
        const auto language = configuration.model_behind(entry.control)->language;
        if (std::ranges::find(settings.controls, language, &NamedControl::language) ==
            settings.controls.end())
            settings.controls.push_back({configuration.control(entry.control), reason()});
    }
}

/// The last entry of "vendor" that takes the path counts.
VendorCode Settings::vendor_code(const Configuration* configuration, const std::string& path) {
    if (configuration == nullptr) return VendorCode::by_remarks;
    const auto entries = configuration->vendor_by_glob.that_take(path);
    if (entries.empty()) return configuration->vendor_by_remarks ? VendorCode::by_remarks : VendorCode::none;
    return configuration->vendor[entries.back()].is_vendor ? VendorCode::whole_file : VendorCode::none;
}

std::optional<FileSettings> Settings::for_file(const std::string& path) {
    const std::string folder = platform::text_of(platform::path_of(path).parent_path());
    const auto found = for_folder(folder.empty() ? "." : folder);
    if (!found) return std::nullopt;
    FileSettings settings;
    settings.configuration = *found;
    settings.max_file_size = overrides_.max_file_size;
    if (*found) say_of_file(**found, path, settings);
    if (overrides_.dialect != nullptr) {
        settings.dialect = overrides_.dialect;
        settings.dialect_reason = "--dialect";
    }
    if (!overrides_.control.empty()) {
        const ControlModel* named =
            *found ? (*found)->control(overrides_.control) : find_control(overrides_.control);
        if (named != nullptr) settings.controls.insert(settings.controls.begin(), {named, "--control"});
    }
    if (!overrides_.machine.empty()) tell_of_machine(settings);
    settings.rules = rules_for(found->get(), path);
    if (!overrides_.baseline.empty())
        settings.baseline = overrides_.baseline;
    else if (*found && !overrides_.no_baseline)
        settings.baseline = (*found)->baseline;
    settings.vendor = overrides_.vendor ? VendorCode::none : vendor_code(found->get(), path);
    settings.complete = overrides_.complete || (*found && (*found)->complete);
    return settings;
}

/// Of the controls that somebody named, and of those that dialects assume.
void Settings::tell_of_machine(FileSettings& settings) {
    for (NamedControl& named : settings.controls) named.control = &with_machine(*named.control);
    for (const Dialect& dialect : dialects())
        if (control_for(dialect, settings.controls) == nullptr)
            settings.controls.push_back(
                {&with_machine(*find_control(dialect.default_control)), "assumed for the dialect"});
}

const ControlModel& Settings::with_machine(const ControlModel& control) {
    auto& made = with_machine_[&control];
    if (made != nullptr) return *made;
    made = std::make_unique<ControlModel>(control);
    overrides_.machine.apply_to(*made);
    for (const ControlModel*& lathe : made->lathes)
        lathe = lathe == &control ? made.get() : &with_machine(*lathe);
    return *made;
}

std::shared_ptr<const RuleStates> Settings::rules_for(const Configuration* configuration,
                                                      const std::string& path) {
    std::vector<std::size_t> ignores;
    if (configuration != nullptr) ignores = configuration->ignores_by_glob.that_take(path);
    if (const auto known = rule_states_.find({configuration, ignores}); known != rule_states_.end())
        return known->second;
    std::shared_ptr<const RuleStates> rules = whole_rules(configuration);
    if (!ignores.empty()) {
        auto fewer = std::make_shared<RuleStates>(*rules);
        for (const std::size_t i : ignores) {
            const PerFileIgnore& entry = configuration->per_file_ignores[i];
            fewer->switch_off(
                rules_of(entry.rules),
                configuration->said_in(entry.source, "per-file-ignores '" + shown(entry.glob.pattern) + "'"));
        }
        rules = std::move(fewer);
    }
    return rule_states_[{configuration, std::move(ignores)}] = std::move(rules);
}

std::shared_ptr<const RuleStates> Settings::whole_rules(const Configuration* configuration) {
    auto& known = rule_states_[{configuration, {}}];
    if (known) return known;
    auto rules = std::make_shared<RuleStates>();
    if (configuration != nullptr) {
        if (overrides_.select.empty()) {
            if (configuration->select)
                rules->select_only(rules_of(*configuration->select), configuration->said_in("select"));
            if (!configuration->ignore.empty())
                rules->switch_off(rules_of(configuration->ignore), configuration->said_in("ignore"));
        }
        for (const auto& [words, severity] : farthest_and_widest_first(configuration->severity))
            rules->set_severity(rules_named(words.word), severity,
                                configuration->said_in(words.source, "severity"));
    }
    apply_overrides(*rules);
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
