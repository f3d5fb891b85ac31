//! Walks folders without recursion; what was seen once, by whatever name, is not seen again.
#include "cli/input/discover.hpp"

#include "analyzer/dialect/dialect.hpp"
#include "analyzer/source/platform/files.hpp"
#include "analyzer/source/platform/output.hpp"
#include "analyzer/source/platform/paths.hpp"
#include "analyzer/source/read.hpp"
#include "cli/input/gitignore.hpp"
#include "cli/input/links.hpp"
#include "cli/input/program_name.hpp"
#include "cli/input/repository.hpp"
#include "cli/text/shown.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <limits>
#include <set>
#include <system_error>

namespace maclint::cli {
namespace {

namespace fs = std::filesystem;

/// Folders that hold what programs made, not programs.
constexpr std::array<std::string_view, 4> passed_over = {"build", "node_modules", "__pycache__",
                                                         "CMakeFiles"};

/// Bounds for files that nobody asked for; a folder of a shop's programs is far below.
struct Bounds {
    std::size_t entries = std::numeric_limits<std::size_t>::max();
    std::size_t files = std::numeric_limits<std::size_t>::max();
    std::uintmax_t bytes = std::numeric_limits<std::uintmax_t>::max();
};
constexpr Bounds context_bounds{200'000, 50'000, 256ULL * 1024 * 1024};

enum class Depth : std::uint8_t { this_folder, all_below };

bool is_passed_over(const std::string& name) {
    return name.starts_with('.') || std::ranges::find(passed_over, name) != passed_over.end();
}

std::string as_shown(const fs::path& path) {
    const std::string normal = platform::text_of(path.lexically_normal());
    return normal.empty() ? "." : normal;
}

bool is_folder(const std::string& path) {
    return platform::kind_of(platform::path_of(path)) == platform::FileKind::folder;
}

/// The file after all symbolic links: what makes two names one file.
std::string identity(const fs::path& path) { return platform::text_of(platform::place_of(path)); }

Notice unreadable_folder(const fs::path& folder, const std::error_code& error) {
    return {NoticeKind::unreadable, as_shown(folder),
            "this folder cannot be read: the system says '" + error.message() +
                "'. Ask its owner for access or exclude it."};
}

bool has_no_extension(const std::string& name) { return name.find('.') == std::string::npos; }

/// Told by the beginning of its text.
bool holds_program(const fs::path& path) {
    constexpr std::size_t looked_at = 4096;
    return is_plainly_a_program(beginning_of_file(platform::text_of(path), looked_at));
}

bool takes_any(const GlobSet& globs, const fs::path& path) { return globs.takes(platform::text_of(path)); }

class Walk {
  public:
    Walk(Settings& settings, Bounds bounds, DiscoverOptions options)
        : settings_(settings)
        , bounds_(bounds)
        , options_(options) {}

    void add_named(const std::string& path, bool standard_input) {
        const fs::path named = platform::path_of(path);
        const std::string real = identity(named);
        if (!seen_.insert(real).second) return;
        bounded_by_.push_back(platform::path_of(real));
        found_.files.push_back(
            {standard_input ? platform::text_of(named) : as_shown(named), true, true, standard_input});
    }

    /// Links may lead into this folder, too: that which holds it after all links.
    void may_lead_into(const std::string& folder) {
        bounded_by_.push_back(platform::place_of(platform::path_of(folder)));
    }

    /// What was named is not found once more.
    void pass_over(const std::string& path) { seen_.insert(identity(platform::path_of(path))); }

    /// How many NC programs are there, those included that were known before.
    std::size_t add_folder(const fs::path& root, Depth depth, bool asked) {
        wanted_ = 0;
        std::vector<Folder> pending = {{root, identity(root)}};
        if (asked) git_.ask_for(pending.front().real);
        while (!pending.empty() && !full_) {
            const Folder folder = std::move(pending.back());
            pending.pop_back();
            if (!folders_.insert(folder.real).second) continue;
            auto below = visit(folder, asked);
            if (depth == Depth::this_folder) break;
            std::ranges::move(below.rbegin(), below.rend(), std::back_inserter(pending));
        }
        return wanted_;
    }

    /// Whether a search of the folders above it would not have come to what was named.
    [[nodiscard]] bool is_left_out(const std::string& named) {
        if (!options_.force_exclude) return false;
        const fs::path path = platform::path_of(named);
        if (options_.gitignore && git_.ignores_path(identity(path), is_folder(named))) return true;
        std::error_code ignored;
        for (fs::path at = fs::absolute(path, ignored).lexically_normal(); at.has_relative_path();) {
            const fs::path folder = at.parent_path();
            const auto loaded = settings_.for_folder(platform::text_of(folder));
            const Configuration* configuration = loaded ? loaded->get() : nullptr;
            if (configuration == nullptr) return false;
            if (is_excluded(configuration, at)) return true;
            at = folder;
        }
        return false;
    }

    /// Ignore files that did not hold.
    void note_unread_rules() {
        for (const InputError& error : git_.unread()) note({NoticeKind::left_out, error.path, error.message});
    }

    [[nodiscard]] bool has_searched(const fs::path& folder) const {
        return folders_.contains(identity(folder));
    }
    [[nodiscard]] const PassedOver& passed_over() const { return found_.passed_over; }
    void note(Notice notice) { found_.notices.push_back(std::move(notice)); }
    [[nodiscard]] bool is_full() const { return full_; }

    Discovered take() {
        std::ranges::stable_sort(found_.files, {}, &InputFile::path);
        return std::move(found_);
    }

  private:
    struct Folder {
        fs::path path;
        std::string real; ///< after all symbolic links
    };

    /// Takes the files of one folder; gives the folders in it, both in the order of their names.
    std::vector<Folder> visit(const Folder& folder, bool asked) {
        std::error_code error;
        std::vector<platform::FolderEntry> entries = platform::entries_of(folder.path, error);
        if (error) {
            if (asked) note(unreadable_folder(folder.path, error));
            return {};
        }
        std::ranges::sort(entries, {},
                          [](const platform::FolderEntry& entry) { return entry.path.native(); });
        const auto loaded = settings_.for_folder(platform::text_of(folder.path));
        const Configuration* configuration = loaded ? loaded->get() : nullptr;
        std::vector<Folder> folders;
        for (const platform::FolderEntry& entry : entries) {
            if (++entries_ > bounds_.entries) full_ = true;
            if (full_) break;
            if (is_excluded(configuration, entry.path))
                list(entry, "excluded by the configuration", asked);
            else
                sort_out(configuration, entry, folder.real, asked, folders);
        }
        return folders;
    }

    /// Takes an entry of the folder `real` when it is a program, adds it to `folders` when it is one.
    void sort_out(const Configuration* configuration, const platform::FolderEntry& entry,
                  const std::string& real, bool asked, std::vector<Folder>& folders) {
        const std::string name = platform::text_of(entry.path.filename());
        if (leads_out(entry, real)) {
            if (asked) count_link(entry, name, real);
            list(entry, "a link out of what is searched", asked);
            return;
        }
        const platform::FileKind kind =
            entry.kind == platform::FileKind::link ? platform::kind_of(entry.path) : entry.kind;
        if (kind == platform::FileKind::folder) {
            if (is_passed_over(name))
                list(entry, "a folder of what programs made", asked && !name.starts_with('.'));
            else if (is_ignored(real, entry, name))
                list(entry, "ignored by git", asked);
            else
                folders.push_back({entry.path, place_of(entry, real)});
            return;
        }
        // A link that leads nowhere is reported when it is read; pipes and devices are not for linting.
        if (kind == platform::FileKind::pipe || kind == platform::FileKind::other || name.starts_with('.'))
            return;
        const std::size_t one = asked ? 1 : 0;
        const bool is_bare = has_no_extension(name);
        if (!is_wanted(configuration, entry.path, name) &&
            !(is_bare && !is_ignored(real, entry, name) && holds_program(entry.path))) {
            found_.passed_over.other_names += is_named_like_other(name) ? 0 : one;
            list(entry, is_bare ? "no extension, and not plainly a program" : "another name", asked);
        } else if (is_ignored(real, entry, name)) {
            found_.passed_over.ignored_by_git += one;
            list(entry, "ignored by git", asked);
        } else {
            take_file(entry, real, asked);
        }
    }

    /// Says by name what the numbers of `passed_over` say.
    void list(const platform::FolderEntry& entry, std::string_view why, bool asked) {
        if (asked && options_.list_passed_over)
            found_.files_passed_over.push_back({as_shown(entry.path), why});
    }

    /// One that is not followed, so that nobody knows what it leads to, but for its name.
    void count_link(const platform::FolderEntry& entry, const std::string& name, const std::string& real) {
        if (is_passed_over(name) || is_named_like_other(name)) return;
        if (!is_ignored(real, entry, name))
            ++found_.passed_over.links_out;
        else if (has_nc_extension(name))
            ++found_.passed_over.ignored_by_git;
    }

    /// Whether an entry of the folder `real` is a link to what is in none of the folders that bound the
    /// search. A folder may be one and not show it (Windows): then the system tells where it is.
    [[nodiscard]] bool leads_out(const platform::FolderEntry& entry, const std::string& real) const {
        if (options_.follow_links || entry.lies_here) return false;
        const fs::path path = platform::path_of(real) / entry.path.filename();
        if (entry.kind == platform::FileKind::link) return end_of(path, bounded_by_) == LinkEnd::outside;
        const fs::path place = platform::place_of(path);
        return std::ranges::none_of(bounded_by_,
                                    [&](const fs::path& folder) { return platform::lies_in(place, folder); });
    }

    /// For git a link is a file, wherever it leads.
    bool is_ignored(const std::string& folder, const platform::FolderEntry& entry, const std::string& name) {
        return options_.gitignore && git_.ignores(folder, name, entry.kind == platform::FileKind::folder);
    }

    static bool is_excluded(const Configuration* configuration, const fs::path& path) {
        return configuration != nullptr && takes_any(configuration->exclude, path);
    }

    static bool is_wanted(const Configuration* configuration, const fs::path& path, const std::string& name) {
        if (has_nc_extension(name)) return true;
        return configuration != nullptr && takes_any(configuration->include, path);
    }

    /// Where an entry of the folder `real` is after all symbolic links. To ask the system for a path takes as
    /// many of its calls as the path has parts.
    static std::string place_of(const platform::FolderEntry& entry, const std::string& real) {
        return entry.lies_here ? platform::text_of(platform::path_of(real) / entry.path.filename())
                               : identity(entry.path);
    }

    void take_file(const platform::FolderEntry& entry, const std::string& real, bool asked) {
        ++wanted_;
        if (!seen_.insert(place_of(entry, real)).second) return;
        // Asking for a size takes a call of the system a file: only where sizes are bounded.
        if (bounds_.bytes != Bounds{}.bytes) bytes_ += platform::size_of(entry.path);
        if (found_.files.size() >= bounds_.files || bytes_ > bounds_.bytes) {
            full_ = true;
            return;
        }
        found_.files.push_back({as_shown(entry.path), false, asked, false});
    }

    Settings& settings_;
    Bounds bounds_;
    DiscoverOptions options_;
    GitIgnore git_;
    Discovered found_;
    std::vector<fs::path> bounded_by_; ///< what was named, after all links
    std::set<std::string> seen_, folders_;
    std::size_t entries_ = 0;
    std::size_t wanted_ = 0;
    std::uintmax_t bytes_ = 0;
    bool full_ = false;
};

/// The folder that holds the programs which a file's programs may call.
struct Home {
    fs::path folder;
    Depth depth;
    friend auto operator<=>(const Home&, const Home&) = default;
};

/// Where a file in the folder looks for others; nothing when those that were found with it have to do.
std::optional<Home> home_of(const fs::path& folder, bool named, Settings& settings) {
    const auto loaded = settings.for_folder(platform::text_of(folder));
    const Configuration* configuration = loaded ? loaded->get() : nullptr;
    if (configuration != nullptr && (named || configuration->complete))
        return Home{platform::path_of(configuration->folder), Depth::all_below};
    if (!named) return std::nullopt;
    if (auto repository = repository_around(folder)) return Home{*std::move(repository), Depth::all_below};
    return Home{folder, Depth::this_folder};
}

/// Of all files, without the folders that have been searched already.
std::set<Home> homes_of(const std::vector<InputFile>& files, const std::vector<std::string>& searched,
                        Settings& settings) {
    std::set<std::pair<std::string, bool>> seen;
    std::set<Home> homes;
    std::error_code ignored;
    for (const InputFile& file : files) {
        const fs::path folder = platform::path_of(file.path).parent_path();
        if (!seen.emplace(platform::text_of(folder), file.named).second) continue;
        const fs::path absolute = fs::absolute(folder.empty() ? "." : folder, ignored).lexically_normal();
        const bool has_slash = !absolute.has_filename();
        if (auto home = home_of(has_slash ? absolute.parent_path() : absolute, file.named, settings))
            homes.insert(*std::move(home));
    }
    for (const std::string& path : searched) {
        if (path == "-" || !is_folder(path)) continue;
        const std::string above = identity(platform::path_of(path));
        std::erase_if(homes, [&](const Home& home) {
            const std::string real = identity(home.folder);
            return real == above || real.starts_with(above.ends_with('/') ? above : above + "/");
        });
    }
    return homes;
}

/// What no file can be found by: nothing, and a path from a folder that is gone.
std::optional<Notice> refuse_path(const std::string& path) {
    if (path == "-") return std::nullopt;
    if (path.empty())
        return Notice{NoticeKind::unreadable, "",
                      "one of the paths is empty and names no file. Write '.' for this folder."};
    std::error_code gone;
    if (platform::path_of(path).is_relative()) static_cast<void>(fs::current_path(gone));
    if (!gone) return std::nullopt;
    return Notice{NoticeKind::unreadable, path,
                  "cannot be found: the folder in which maclint was started is gone. Change to another one."};
}

Notice left_out(const std::string& path) {
    return {
        NoticeKind::left_out, as_shown(platform::path_of(path)),
        "this is excluded or ignored by git, so it is not checked. Leave --force-exclude out to check it."};
}

Notice links_out_of(const std::string& folder, std::size_t links) {
    const bool one = links == 1;
    return {NoticeKind::left_out, as_shown(platform::path_of(folder)),
            counted(links, "link") + (one ? " in this folder leads" : " in this folder lead") +
                " out of it and " + (one ? "is" : "are") +
                " not followed. Say --follow-links to have checked what is there."};
}

Notice without_programs(const std::string& folder, const PassedOver& passed_over) {
    const std::string others = text_of(passed_over);
    const std::string cure = passed_over.links_out > 0
                                 ? "Say --follow-links to have checked what is behind links, or name files "
                                   "themselves."
                                 : "Name files themselves when they have unusual names, or add 'include' to "
                                   "the configuration.";
    return {NoticeKind::left_out, as_shown(platform::path_of(folder)),
            "no NC program is in this folder" + (others.empty() ? "" : " (" + others + ")") + ". " + cure};
}

/// A folder without programs is told of, or else links that were not followed.
void search(Walk& walk, const std::string& folder) {
    const PassedOver before = walk.passed_over();
    const std::size_t programs = walk.add_folder(platform::path_of(folder), Depth::all_below, true);
    const PassedOver added = walk.passed_over() - before;
    if (programs == 0)
        walk.note(without_programs(folder, added));
    else if (added.links_out > 0)
        walk.note(links_out_of(folder, added.links_out));
}

} // namespace

Discovered discover(const std::vector<std::string>& paths, const std::string& stdin_name, Settings& settings,
                    DiscoverOptions options) {
    Walk walk(settings, {}, options);
    const auto add = [&](const std::string& path, bool standard_input) {
        if (walk.is_left_out(path))
            walk.note(left_out(path));
        else
            walk.add_named(path, standard_input);
    };
    // First, for it stands for the file of its name.
    if (std::ranges::find(paths, "-") != paths.end()) add(stdin_name, true);
    for (const std::string& path : paths) {
        if (auto refused = refuse_path(path))
            walk.note(*std::move(refused));
        else if (path != "-" && !is_folder(path))
            add(path, false);
    }
    for (const std::string& path : paths)
        if (path != "-" && is_folder(path)) walk.may_lead_into(path);
    std::set<std::string> folders;
    for (const std::string& path : paths) {
        if (path == "-" || !is_folder(path) || refuse_path(path)) continue;
        if (!folders.insert(identity(platform::path_of(path))).second) continue;
        if (walk.is_left_out(path))
            walk.note(left_out(path));
        else if (!walk.has_searched(platform::path_of(path))) // as a part of another one
            search(walk, path);
    }
    walk.note_unread_rules();
    return walk.take();
}

Discovered discover_context(const std::vector<InputFile>& asked, const std::vector<std::string>& paths,
                            Settings& settings, DiscoverOptions options) {
    const auto homes = homes_of(asked, paths, settings);
    if (homes.empty()) return {};
    Walk walk(settings, context_bounds, options);
    for (const InputFile& file : asked) walk.pass_over(file.path);
    for (const Home& home : homes) walk.may_lead_into(platform::text_of(home.folder));
    std::error_code ignored;
    const fs::path here = fs::current_path(ignored);
    for (const Home& home : homes) {
        const fs::path shorter = home.folder.lexically_proximate(here);
        const bool below = shorter.empty() || *shorter.begin() != "..";
        walk.add_folder(below ? shorter : home.folder, home.depth, false);
    }
    if (walk.is_full())
        walk.note({NoticeKind::left_out, platform::text_of(homes.begin()->folder),
                   "this folder holds too many files to look for callers and callees in all of them. Add a " +
                       std::string(configuration_name) +
                       " to the folder that holds the programs of one control."});
    return walk.take();
}

} // namespace maclint::cli
