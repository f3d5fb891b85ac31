//! All globs are asked of each file once.
#include "cli/config/idle_globs.hpp"

#include "analyzer/source/platform/files.hpp"
#include "analyzer/source/platform/paths.hpp"
#include "cli/text/shown.hpp"

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <iterator>
#include <string_view>

namespace maclint::cli {
namespace {

struct Entry {
    std::string_view key;
    Glob glob;
};

/// Those that stand in the configuration itself.
std::vector<Entry> own_entries(const Configuration& configuration) {
    std::vector<Entry> entries;
    for (const FileEntry& file : configuration.files)
        if (file.source == 0) entries.push_back({"files", file.glob});
    for (const PerFileIgnore& ignore : configuration.per_file_ignores)
        if (ignore.source == 0) entries.push_back({"per-file-ignores", ignore.glob});
    for (const VendorEntry& vendor : configuration.vendor)
        if (vendor.source == 0) entries.push_back({"vendor", vendor.glob});
    const auto include = configuration.source_of_key.find("include");
    if (include != configuration.source_of_key.end() && include->second == 0)
        for (const Glob& glob : configuration.included) entries.push_back({"include", glob});
    return entries;
}

/// By place in `globs`, whether any of the files is taken.
std::vector<bool> used(const std::vector<Glob>& globs, const std::vector<InputFile>& files) {
    std::vector<bool> used(globs.size());
    const GlobSet set(globs);
    for (const InputFile& file : files)
        for (const std::size_t i : set.that_take(file.path)) used[i] = true;
    return used;
}

/// Of each glob one that takes folders below, too.
std::vector<Glob> at_any_depth(const std::vector<Entry>& entries) {
    std::vector<Glob> globs;
    for (const Entry& entry : entries) {
        std::string_view pattern = entry.glob.pattern;
        while (pattern.starts_with("./") || pattern.starts_with('/'))
            pattern.remove_prefix(pattern.find('/') + 1);
        globs.push_back({"**/" + std::string(pattern), entry.glob.folder});
    }
    return globs;
}

std::vector<Notice> idle_globs_of(const Configuration& configuration, const std::vector<InputFile>& files) {
    const std::vector<Entry> entries = own_entries(configuration);
    std::vector<Glob> globs;
    for (const Entry& entry : entries) globs.push_back(entry.glob);
    const std::vector<bool> is_used = used(globs, files);
    if (std::ranges::find(is_used, false) == is_used.end()) return {};
    const std::vector<Glob> deeper = at_any_depth(entries);
    const std::vector<bool> is_deeper = used(deeper, files);
    std::vector<Notice> notices;
    for (std::size_t i = 0; i < entries.size(); ++i) {
        if (is_used[i]) continue;
        const std::string cure =
            is_deeper[i]
                ? "Write \"" + shown(deeper[i].pattern) + "\" where such files at any depth are meant."
                : "Correct it (it is relative to the folder of the configuration; '*' stays within a "
                  "name, '**' goes through folders), or take the entry out.";
        notices.push_back({NoticeKind::idle_setting, configuration.path,
                           std::string(entries[i].key) + " '" + shown(entries[i].glob.pattern) +
                               "' takes no program of the folder. " + cure});
    }
    return notices;
}

/// Absolute, without a slash at the end.
std::string whole_path(const std::string& folder) {
    std::error_code gone;
    const auto whole = std::filesystem::absolute(platform::path_of(folder), gone).lexically_normal();
    std::string text = platform::text_of(whole);
    while (text.ends_with('/')) text.pop_back();
    return text;
}

} // namespace

std::vector<Notice> idle_globs(const std::vector<std::shared_ptr<const Configuration>>& configurations,
                               const std::vector<std::string>& paths, const std::vector<InputFile>& files) {
    std::vector<std::string> folders;
    for (const std::string& path : paths)
        if (platform::kind_of(platform::path_of(path)) == platform::FileKind::folder)
            folders.push_back(whole_path(path) + "/");
    std::vector<Notice> notices;
    for (const auto& configuration : configurations) {
        const auto holds = [&](const std::string& folder) {
            return (configuration->folder + "/").starts_with(folder);
        };
        if (std::ranges::any_of(folders, holds))
            std::ranges::move(idle_globs_of(*configuration, files), std::back_inserter(notices));
    }
    return notices;
}

} // namespace maclint::cli
