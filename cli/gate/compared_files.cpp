//! Files that were there under their name first, then the new ones under the names that they had.
#include "cli/gate/compared_files.hpp"

#include "analyzer/source/platform/files.hpp"
#include "analyzer/source/platform/paths.hpp"
#include "cli/gate/renamed_files.hpp"
#include "cli/input/git_folders.hpp"
#include "cli/text/shown.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <string_view>
#include <utility>

namespace maclint::cli {
namespace {

constexpr std::size_t megabyte = std::size_t{1} << 20U;

/// https://github.com/git-lfs/git-lfs/blob/main/docs/spec.md: what git holds in place of a large file.
bool is_pointer(std::string_view text) {
    constexpr std::size_t longest = 1024;
    return text.size() < longest && text.starts_with("version https://git-lfs.github.com/spec/");
}

/// A text that is so much larger than the file is not worth reading: hardly any of the file's lines can be
/// found there by more than chance, and a small repository can hold texts of any size.
bool is_out_of_proportion(std::uint64_t before, std::size_t now) { return before > 16 * now + megabyte; }

/// Whether less than half of it is in the other, whatever their line ends are.
bool is_far_from(std::uint64_t size, std::size_t other) { return size > 3 * other || other > 3 * size; }

class Comparison {
  public:
    Comparison(const RepositoryHistory& history, const std::string& revision,
               const std::vector<FileToCompare>& files)
        : history_(history)
        , revision_(revision)
        , files_(files) {}

    [[nodiscard]] ComparedFiles compare() {
        std::vector<Pair> pairs;
        bool has_new = false;
        for (const FileToCompare& file : files_) {
            if (file.wanted == FileToCompare::Wanted::nothing) continue;
            if (const auto id = history_.id_of(file.path)) {
                pairs.push_back({&file, *id});
            } else {
                has_new = true;
            }
        }
        compare_texts(pairs);
        if (has_new && !is_sparse(platform::path_of(history_.root()))) compare_texts(renamed_pairs());
        tell();
        return std::move(compared_);
    }

  private:
    struct Pair {
        const FileToCompare* file;
        std::string_view id;
    };
    using ById = std::map<std::string_view, std::vector<const FileToCompare*>>;

    void fail(Notice notice) { compared_.notices.push_back(std::move(notice)); }

    void compare_texts(const std::vector<Pair>& pairs) {
        ById by_id;
        for (const Pair& pair : pairs) by_id[pair.id].push_back(pair.file);
        std::vector<std::string_view> ids;
        for (const auto& [id, files] : by_id) ids.push_back(id);
        auto sizes = history_.sizes_of(ids);
        if (auto* const failure = std::get_if<Notice>(&sizes)) return fail(std::move(*failure));
        const auto wanted = worth_reading(ids, std::get<0>(sizes), by_id);
        auto failure = history_.read(wanted, [&](std::size_t index, const std::string& text) {
            for (const FileToCompare* file : by_id.at(wanted[index])) compare_text(*file, text);
        });
        if (failure) fail(*std::move(failure));
    }

    std::vector<std::string_view> worth_reading(const std::vector<std::string_view>& ids,
                                                const std::vector<std::optional<std::uint64_t>>& sizes,
                                                const ById& by_id) {
        std::vector<std::string_view> wanted;
        for (std::size_t i = 0; i < ids.size(); ++i) {
            const auto& files = by_id.at(ids[i]);
            std::size_t largest = 0;
            for (const FileToCompare* file : files)
                largest = std::max<std::size_t>(largest, file->source->size());
            if (!sizes[i]) {
                missing_.insert(missing_.end(), files.begin(), files.end());
            } else if (*sizes[i] <= RepositoryHistory::largest_text &&
                       !is_out_of_proportion(*sizes[i], largest)) {
                wanted.push_back(ids[i]);
            }
        }
        return wanted;
    }

    void compare_text(const FileToCompare& file, std::string_view before) {
        const std::string_view now = file.source->stored_bytes();
        if (is_pointer(before) != is_pointer(now)) {
            pointers_.push_back(&file);
        } else {
            compared_.ranges[file.source] = changed_lines(before, now);
        }
    }

    /// New files, each with the text of the gone file that it was.
    std::vector<Pair> renamed_pairs() {
        std::map<std::string, const Source*> added;
        for (const FileToCompare& file : files_)
            if (!history_.id_of(file.path)) added.try_emplace(file.path, file.source);
        std::size_t lines = 0;
        for (const auto& [path, source] : added) lines += LineBag::count_lines(source->stored_bytes());
        const auto gone = gone_like(added, lines);
        if (gone.empty()) return {};
        std::vector<NamedLines> newer;
        for (const auto& [path, source] : added) newer.push_back({path, LineBag(source->stored_bytes())});
        const Renames renames = find_renames(gone, newer);
        bound_was_met_ |= renames.bound_was_met;
        std::vector<Pair> pairs;
        for (const FileToCompare& file : files_) {
            const auto was = renames.gone_by_new.find(file.path);
            if (was == renames.gone_by_new.end() || file.wanted == FileToCompare::Wanted::nothing) continue;
            if (const auto id = history_.id_of(was->second)) pairs.push_back({&file, *id});
        }
        return pairs;
    }

    /// The files that are gone and are about as large as one that is new, as far as the repository has them.
    /// `lines` is how many the new ones have together.
    std::vector<NamedLines> gone_like(const std::map<std::string, const Source*>& added, std::size_t lines) {
        constexpr std::size_t most = 256 * megabyte;
        constexpr std::size_t most_lines = 4'000'000; // of both sides: they are held at once, 64 MB
        std::vector<std::size_t> added_sizes;
        for (const auto& [path, source] : added) added_sizes.push_back(source->size());
        std::ranges::sort(added_sizes);
        const auto is_like_one = [&](std::uint64_t size) {
            const auto near = std::ranges::lower_bound(added_sizes, size / 3);
            return near != added_sizes.end() && (!is_far_from(size, *near) || *near <= size);
        };
        std::vector<std::string_view> paths;
        std::vector<std::string_view> ids;
        for (const auto& [path, id] : history_.files()) {
            if (!is_gone(path)) continue;
            paths.push_back(path);
            ids.push_back(id);
        }
        auto sizes = history_.sizes_of(ids);
        if (auto* const failure = std::get_if<Notice>(&sizes)) {
            fail(std::move(*failure));
            return {};
        }
        std::vector<std::string_view> near_paths;
        std::vector<std::string_view> near_ids;
        std::uint64_t bytes = 0;
        for (std::size_t i = 0; i < ids.size(); ++i) {
            const auto size = std::get<0>(sizes)[i];
            if (!size || !is_like_one(*size)) continue;
            bytes += *size;
            near_paths.push_back(paths[i]);
            near_ids.push_back(ids[i]);
        }
        bound_was_met_ |= bytes > most;
        std::vector<NamedLines> gone;
        if (bytes > most) return gone;
        auto failure = history_.read(near_ids, [&](std::size_t index, const std::string& text) {
            lines += LineBag::count_lines(text);
            if (lines > most_lines) return;
            gone.push_back({std::string(near_paths[index]), LineBag(text)});
        });
        if (failure) fail(*std::move(failure));
        if (lines <= most_lines) return gone;
        bound_was_met_ = true; // which of those that were read come first must not matter
        return {};
    }

    [[nodiscard]] bool is_gone(std::string_view path) const {
        // No tree that git writes has such names, and they would lead out of the folder.
        const auto named = platform::path_of(path);
        if (named.has_root_path() || std::ranges::find(named, "..") != named.end()) return false;
        // No file of Windows has such a name, and put behind a folder's it may lead to a server.
        if (platform::paths_may_name_servers() && path.find_first_of("\\:") != std::string_view::npos)
            return false;
        return platform::kind_of(platform::path_of(history_.root()) / named) == platform::FileKind::missing;
    }

    /// "'a.nc' and 3 others".
    static std::string names(const std::vector<const FileToCompare*>& files) {
        const std::string first = "'" + shown(files.front()->source->path()) + "'";
        return files.size() == 1 ? first : first + " and " + counted(files.size() - 1, "other");
    }

    void tell() {
        const std::string revision = "'" + shown(revision_) + "'";
        std::ranges::sort(missing_, {},
                          [](const FileToCompare* file) { return std::string_view(file->path); });
        if (!missing_.empty())
            fail({NoticeKind::unreadable, "",
                  "--since lacks " + names(missing_) + " as of " + revision +
                      ", so that all lines there count as changed: the repository was fetched in part, or is "
                      "damaged. Fetch all of it, such as by 'git fetch --refetch --no-filter'."});
        if (!pointers_.empty())
            fail({NoticeKind::left_out, "",
                  "all lines of " + names(pointers_) +
                      " count as changed: git holds a pointer to a large file "
                      "in their place."});
        if (bound_was_met_)
            fail({NoticeKind::left_out, "",
                  "too much is gone since " + revision +
                      " to find out which new files were renamed: all lines of those that were changed, too, "
                      "count as changed."});
    }

    const RepositoryHistory& history_;
    const std::string& revision_;
    const std::vector<FileToCompare>& files_;
    ComparedFiles compared_;
    std::vector<const FileToCompare*> missing_, pointers_;
    bool bound_was_met_ = false;
};

} // namespace

ComparedFiles compare_files(const RepositoryHistory& history, const std::string& revision,
                            const std::vector<FileToCompare>& files) {
    return Comparison(history, revision, files).compare();
}

} // namespace maclint::cli
