//! gitrepository-layout(5) says which files name others, git-config(1) which settings do.
#include "cli/gate/git_refusals.hpp"

#include "analyzer/source/platform/files.hpp"
#include "analyzer/source/platform/paths.hpp"
#include "analyzer/source/read.hpp"
#include "cli/input/git_folders.hpp"
#include "cli/input/links.hpp"
#include "cli/input/other_server.hpp"
#include "cli/input/size_limits.hpp"
#include "cli/text/shown.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <set>
#include <utility>
#include <variant>

namespace maclint::cli {
namespace {

namespace fs = std::filesystem;
using platform::FileKind;
using platform::path_of;
using platform::text_of;

std::string without_line_end(std::string text) {
    text.erase(text.find_last_not_of("\r\n") + 1);
    return text;
}

/// A name in quotes is written as in C.
std::string unquoted(std::string_view name) {
    if (!name.starts_with('"')) return std::string(name);
    name.remove_prefix(1);
    if (name.ends_with('"')) name.remove_suffix(1);
    constexpr std::string_view letters = "abtnvfr";
    constexpr std::string_view meant = "\a\b\t\n\v\f\r";
    std::string out;
    for (std::size_t i = 0; i < name.size(); ++i) {
        if (name[i] != '\\' || i + 1 == name.size()) {
            out += name[i];
            continue;
        }
        const char escaped = name[++i];
        if (const auto letter = letters.find(escaped); letter != std::string_view::npos) {
            out += meant[letter];
        } else if (unsigned code = 0;
                   std::from_chars(&name[i], &name[i] + std::min<std::size_t>(3, name.size() - i), code, 8)
                       .ec == std::errc{}) {
            out += static_cast<char>(code);
            i += 2;
        } else {
            out += escaped;
        }
    }
    return out;
}

/// gitrepository-layout(5), but for the texts of objects and of single references: files whose lines git
/// reads, and so may quote.
constexpr auto read_by_git = std::to_array<std::string_view>({
    "HEAD",
    "ORIG_HEAD",
    "FETCH_HEAD",
    "MERGE_HEAD",
    "CHERRY_PICK_HEAD",
    "REVERT_HEAD",
    "BISECT_HEAD",
    "REBASE_HEAD",
    "AUTO_MERGE",
    "config",
    "config.worktree",
    "commondir",
    "gitdir",
    "packed-refs",
    "shallow",
    "index",
    "info/refs",
    "info/grafts",
    "info/exclude",
    "info/attributes",
    "info/sparse-checkout",
    "logs/HEAD",
    "objects/info/packs",
    "objects/info/alternates",
    "objects/info/http-alternates",
    "objects/info/commit-graph",
    "objects/info/commit-graphs/commit-graph-chain",
    "objects/pack/multi-pack-index",
    "reftable/tables.list",
});

/// Files and settings that name others, followed as far as they lead to no other server.
class ServerSearch {
  public:
    explicit ServerSearch(const GitPlace& place)
        : place_(place)
        , root_(place.root) {}

    [[nodiscard]] std::optional<Notice> refuse() {
        const fs::path git = path_of(root_) / ".git";
        fs::path own = git;
        if (const std::string named = path_named_in(text_in(git), "gitdir: "); !named.empty()) {
            if (!allows(git, named)) return refusal_;
            own = path_of(root_) / path_of(named);
        }
        fs::path common = own;
        const fs::path file = own / "commondir";
        if (const std::string named = path_named_in(text_in(file), ""); !named.empty()) {
            if (!allows(file, named)) return refusal_;
            common = own / path_of(named);
        }
        look_at_alternates(common / "objects");
        look_at_settings(common / "config");
        look_at_settings(own / "config.worktree");
        return refusal_;
    }

  private:
    /// Whether a file may name a path; from the first on that may not, nothing more is looked at.
    bool allows(const fs::path& file, const std::string& named) {
        if (names_other_server(named, root_) && !refusal_)
            refusal_ = refusal_of_since("--since does not ask git about '" + shown(root_) + "': '" +
                                        shown(text_of(file)) + "' names a path on another server, '" +
                                        shown(named) + "'. Take it out, or leave --since out.");
        return !refusal_;
    }

    /// What a file holds; nothing when there is none. One that cannot be read whole may name anything.
    std::string text_in(const fs::path& file) {
        if (platform::kind_of(file) != FileKind::regular) return {};
        const auto read = read_file(text_of(file), git_list_limit);
        if (const auto* const source = std::get_if<Source>(&read)) return std::string(source->bytes());
        if (!refusal_)
            refusal_ = refusal_of_since("--since does not ask git about '" + shown(root_) +
                                        "': " + std::get<InputError>(read).message);
        return {};
    }

    bool is_new(const fs::path& path) {
        constexpr std::size_t most = 100; // git gives up far earlier
        return !refusal_ && seen_.size() < most && seen_.insert(path.lexically_normal()).second;
    }

    void look_at_alternates(const fs::path& objects) {
        if (!is_new(objects)) return;
        const fs::path file = objects / "info" / "alternates";
        const std::string text = text_in(file);
        for (std::string_view rest = text; !rest.empty();) {
            std::string line(rest.substr(0, rest.find('\n')));
            rest.remove_prefix(std::min(rest.size(), line.size() + 1));
            line = unquoted(without_line_end(line));
            if (line.empty() || line.starts_with('#')) continue;
            if (!allows(file, line)) return;
            look_at_alternates(objects / path_of(line));
        }
    }

    void look_at_settings(const fs::path& file) {
        if (!is_new(file) || platform::kind_of(file) != FileKind::regular) return;
        const GitAnswer listed = list_settings(place_, text_of(file));
        for (std::string_view rest = listed.text; !rest.empty() && !refusal_;) {
            const std::string_view setting = rest.substr(0, rest.find('\0'));
            rest.remove_prefix(std::min(rest.size(), setting.size() + 1));
            const auto line = setting.find('\n');
            if (line != std::string_view::npos)
                look_at_setting(file, setting.substr(0, line), std::string(setting.substr(line + 1)));
        }
    }

    void look_at_setting(const fs::path& file, std::string_view key, std::string value) {
        constexpr std::string_view optional = ":(optional)";
        if (value.starts_with(optional)) value.erase(0, optional.size());
        const bool includes =
            key == "include.path" || (key.starts_with("includeif.") && key.ends_with(".path"));
        // Where references are kept may be said behind the name of the way to keep them.
        const auto place = key.starts_with("extensions.") ? value.find("://") : std::string::npos;
        if (place != std::string::npos) value.erase(0, place + 3);
        if (!includes && key != "core.worktree" && place == std::string::npos) return;
        const bool is_of_user = value.starts_with('~') || value.starts_with("%(prefix)");
        if (!allows(file, value) || !includes || is_of_user) return;
        look_at_settings(file.parent_path() / path_of(value));
    }

    const GitPlace& place_;
    const std::string& root_;
    std::set<fs::path> seen_;
    std::optional<Notice> refusal_;
};

} // namespace

std::optional<Notice> refuse_special_files(const std::string& root) {
    const auto folders = git_folders_of(path_of(root));
    const auto follow = [](const fs::path& path) {
        return follow_links(path, [](const fs::path&) { return true; }).value_or(path);
    };
    const std::array ends = {follow(folders.own), follow(folders.common)};
    for (const fs::path& folder : {folders.own, folders.common}) {
        for (const std::string_view name : read_by_git) {
            const fs::path file = folder / path_of(name);
            const FileKind kind =
                end_of(file, ends) == LinkEnd::inside ? platform::kind_of(file) : FileKind::link;
            std::string_view what;
            if (kind == FileKind::link) what = "' is a link that leads out of the repository's .git";
            if (kind == FileKind::pipe || kind == FileKind::other) what = "' is a pipe or a device";
            if (!what.empty())
                return refusal_of_since("--since cannot ask git about '" + shown(root) + "': '" +
                                        shown(text_of(file)) + std::string(what) +
                                        ". Mend the repository, or leave --since out.");
        }
    }
    return std::nullopt;
}

std::optional<Notice> refuse_other_servers(const GitPlace& place) { return ServerSearch(place).refuse(); }

} // namespace maclint::cli
