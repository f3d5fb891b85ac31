//! Lines become globs of ours, name by name; the last one that matches counts, that of the deepest file
//! first.
#include "cli/input/gitignore.hpp"

#include "analyzer/source/platform/files.hpp"
#include "analyzer/source/platform/paths.hpp"
#include "analyzer/source/source.hpp"
#include "cli/config/glob.hpp"
#include "cli/input/git_folders.hpp"
#include "cli/input/links.hpp"
#include "cli/input/repository.hpp"
#include "cli/input/size_limits.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <optional>
#include <system_error>
#include <utility>

namespace maclint::cli {
namespace {

namespace fs = std::filesystem;

struct CharacterClass {
    std::string_view name, members;
};
constexpr std::array<CharacterClass, 7> classes{{{"alnum", "a-zA-Z0-9"},
                                                 {"alpha", "a-zA-Z"},
                                                 {"digit", "0-9"},
                                                 {"lower", "a-z"},
                                                 {"upper", "A-Z"},
                                                 {"space", " \t\r\n\v\f"},
                                                 {"xdigit", "0-9a-fA-F"}}};

/// Makes a glob of ours, which knows no '\', of a pattern of git's: what stands for itself is put into a set.
class Translation {
  public:
    explicit Translation(std::string_view pattern)
        : rest_(pattern) {}

    /// A glob for each name; nothing when git lets the pattern match nothing.
    std::optional<std::vector<std::string>> take() {
        std::vector<std::string> names(1);
        while (!rest_.empty()) {
            const char c = next();
            if (c == '/') {
                names.emplace_back();
            } else if (c == '\\') {
                if (rest_.empty()) return std::nullopt;
                const char literal = next();
                names.back() += std::string_view("*?[").find(literal) == std::string_view::npos
                                    ? std::string(1, literal)
                                    : std::string("[") + literal + "]";
            } else if (c == '[') {
                if (!take_set(names.back())) return std::nullopt;
            } else {
                names.back() += c;
            }
        }
        return names;
    }

  private:
    char next() {
        const char c = rest_.front();
        rest_.remove_prefix(1);
        return c;
    }

    /// In our sets ']' stands first, '-' before all ranges, and '!' does not stand first.
    bool take_set(std::string& out) {
        const bool inverted = rest_.starts_with('!') || rest_.starts_with('^');
        if (inverted) rest_.remove_prefix(1);
        std::string members;
        bool bracket = false, mark = false, dash = false;
        for (bool first = true; first || !rest_.starts_with(']'); first = false) {
            if (rest_.empty()) return false;
            if (take_class(members)) continue;
            const auto begin = take_member();
            if (!begin) return false;
            if (rest_.size() > 1 && rest_[0] == '-' && rest_[1] != ']') {
                rest_.remove_prefix(1);
                const auto end = take_member();
                if (!end) return false;
                members += std::string(1, *begin) + '-' + *end;
            } else {
                bracket = bracket || *begin == ']';
                mark = mark || *begin == '!';
                dash = dash || *begin == '-';
                if (*begin != ']' && *begin != '!' && *begin != '-') members += *begin;
            }
        }
        rest_.remove_prefix(1);
        const bool mark_alone = mark && !inverted && !bracket && !dash && members.empty();
        if (mark_alone)
            out += '!';
        else
            out.append(inverted ? "[!" : "[")
                .append(bracket ? "]" : "")
                .append(dash ? "-" : "")
                .append(members)
                .append(mark ? "!]" : "]");
        return true;
    }

    std::optional<char> take_member() {
        char c = next();
        if (c != '\\') return c;
        if (rest_.empty()) return std::nullopt;
        c = next();
        return c;
    }

    bool take_class(std::string& members) {
        if (!rest_.starts_with("[:")) return false;
        const std::size_t end = rest_.find(":]");
        if (end == std::string_view::npos) return false;
        const auto* const known = std::ranges::find(classes, rest_.substr(2, end - 2), &CharacterClass::name);
        if (known == classes.end()) return false;
        members += known->members;
        rest_.remove_prefix(end + 2);
        return true;
    }

    std::string_view rest_;
};

/// Blanks at the end do not count, unless there is a '\' before them.
std::string_view without_trailing_blanks(std::string_view line) {
    std::size_t end = 0;
    for (std::size_t at = 0; at < line.size(); ++at) {
        if (line[at] == ' ') continue;
        if (line[at] == '\\') ++at;
        end = std::min(at + 1, line.size());
    }
    return line.substr(0, end);
}

std::optional<IgnoreRule> read_rule(std::string_view line) {
    if (line.ends_with('\r')) line.remove_suffix(1);
    if (line.starts_with('#')) return std::nullopt;
    line = without_trailing_blanks(line);
    IgnoreRule rule;
    rule.wanted = line.starts_with('!');
    if (rule.wanted) line.remove_prefix(1);
    rule.folders_only = line.ends_with('/');
    if (rule.folders_only) line.remove_suffix(1);
    rule.anchored = line.find('/') != std::string_view::npos;
    if (line.starts_with('/')) line.remove_prefix(1);
    if (line.empty()) return std::nullopt;
    auto names = Translation(line).take();
    if (!names) return std::nullopt;
    rule.names = *std::move(names);
    return rule;
}

bool matches(const IgnoreRule& rule, const std::vector<std::string_view>& names) {
    if (rule.anchored) return matches_names(rule.names, names);
    return matches_name(rule.names.front(), names.back());
}

bool has_wildcard(const IgnoreRule& rule) {
    return std::ranges::any_of(
        rule.names, [](const std::string& name) { return name.find_first_of("*?[") != std::string::npos; });
}

template<class Names>
std::string joined(const Names& names) {
    std::string path;
    for (const auto& name : names) path.append(path.empty() ? "" : "/").append(name);
    return path;
}

} // namespace

std::vector<IgnoreRule> read_ignore_rules(std::string_view text) {
    constexpr std::string_view mark = "\xEF\xBB\xBF";
    if (text.starts_with(mark)) text.remove_prefix(mark.size());
    std::vector<IgnoreRule> rules;
    while (!text.empty()) {
        const std::string_view line = text.substr(0, text.find('\n'));
        if (auto rule = read_rule(line)) rules.push_back(*std::move(rule));
        text.remove_prefix(std::min(text.size(), line.size() + 1));
    }
    return rules;
}

IndexedRules::IndexedRules(std::vector<IgnoreRule> rules)
    : rules_(std::move(rules)) {
    for (std::size_t i = 0; i < rules_.size(); ++i) {
        const IgnoreRule& rule = rules_[i];
        if (has_wildcard(rule)) {
            with_wildcards_.push_back(i);
        } else {
            Last& last = rule.anchored ? by_path_[joined(rule.names)] : by_name_[rule.names.front()];
            (rule.folders_only ? last.of_folders : last.of_all) = i + 1;
        }
    }
}

std::size_t IndexedRules::last_of(const ByText& rules, const std::string& text, bool is_folder) {
    const auto found = rules.find(text);
    if (found == rules.end()) return 0;
    return is_folder ? std::max(found->second.of_all, found->second.of_folders) : found->second.of_all;
}

std::optional<bool> IndexedRules::pass_over(const std::vector<std::string_view>& names,
                                            bool is_folder) const {
    std::size_t last = last_of(by_name_, std::string(names.back()), is_folder);
    if (!by_path_.empty()) last = std::max(last, last_of(by_path_, joined(names), is_folder));
    for (auto at = with_wildcards_.rbegin(); at != with_wildcards_.rend() && *at >= last; ++at)
        if ((is_folder || !rules_[*at].folders_only) && matches(rules_[*at], names)) last = *at + 1;
    return last == 0 ? std::nullopt : std::optional(!rules_[last - 1].wanted);
}

GitIgnore::Chain GitIgnore::with_file(Chain above, const std::string& folder, const fs::path& file) {
    // Nor does git follow a link in its place.
    if (platform::kind_unfollowed(file) != platform::FileKind::regular) return above;
    auto read = read_file(platform::text_of(file), ignore_file_limit);
    if (auto* error = std::get_if<InputError>(&read)) {
        unread_.push_back(std::move(*error));
        return nullptr;
    }
    auto rules = read_ignore_rules(std::get<Source>(read).bytes());
    if (rules.empty()) return above;
    IndexedRules indexed(std::move(rules));
    const std::size_t wildcards = indexed.wildcards() + (above == nullptr ? 0 : above->wildcards);
    if (wildcards > most_ignore_wildcards) {
        unread_.push_back(
            {platform::text_of(file), "holds, with the files above it, more than " +
                                          std::to_string(most_ignore_wildcards) +
                                          " patterns with wildcards. What it names is checked."});
        return nullptr;
    }
    return std::make_shared<const Rules>(Rules{std::move(above), folder, std::move(indexed), wildcards});
}

const GitIgnore::Known& GitIgnore::known_of(const std::string& folder) {
    if (const auto known = by_folder_.find(folder); known != by_folder_.end()) return known->second;
    const fs::path path = platform::path_of(folder);
    Known known;
    if (is_repository(path)) {
        const fs::path git = git_folders_of(path).common;
        const fs::path exclude = git / "info" / "exclude";
        known = {leaves_drive(exclude, git) ? nullptr : with_file(nullptr, folder, exclude), true};
    } else if (path.has_relative_path()) {
        known = known_of(platform::text_of(path.parent_path()));
    }
    if (known.in_repository) known.rules = with_file(std::move(known.rules), folder, path / ".gitignore");
    return by_folder_.emplace(folder, std::move(known)).first->second;
}

bool GitIgnore::ignores(const std::string& folder, const std::string& name, bool is_folder) {
    const Chain& rules = known_of(folder).rules;
    const std::string path = folder + "/" + name;
    for (const Rules* file = rules.get(); file != nullptr; file = file->above.get()) {
        const auto names = names_of(std::string_view(path).substr(file->folder.size()));
        if (const auto passed_over = file->rules.pass_over(names, is_folder)) return *passed_over;
    }
    return false;
}

bool GitIgnore::ignores_path(const std::string& path, bool is_folder) {
    const fs::path at = platform::path_of(path);
    const std::string folder = platform::text_of(at.parent_path());
    if ((is_folder && is_repository(at)) || !at.has_relative_path() || !known_of(folder).in_repository)
        return false;
    return ignores(folder, platform::text_of(at.filename()), is_folder) || ignores_path(folder, true);
}

void GitIgnore::ask_for(const std::string& folder) {
    if (ignores_path(folder, true))
        by_folder_[folder] = {with_file(nullptr, folder, platform::path_of(folder) / ".gitignore"), true};
}

} // namespace maclint::cli
