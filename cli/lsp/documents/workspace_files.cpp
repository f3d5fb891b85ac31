//! Folders are searched as `check` searches those that it is given.
#include "cli/lsp/documents/workspace_files.hpp"

#include "analyzer/source/platform/files.hpp"
#include "analyzer/source/platform/paths.hpp"
#include "cli/input/discover.hpp"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <unordered_set>
#include <utility>

namespace maclint::cli::lsp {
namespace {

namespace fs = std::filesystem;

/// Configurations may name files within the editor's folders, and none elsewhere.
std::vector<fs::path> real_folders(const std::vector<std::string>& folders) {
    std::vector<fs::path> real;
    for (const std::string& folder : folders) {
        std::error_code missing;
        fs::path path = platform::real_path(platform::path_of(folder), missing);
        if (!missing && path.has_relative_path()) real.push_back(std::move(path));
    }
    return real;
}

Overrides no_configuration() {
    Overrides overrides;
    overrides.isolated = true;
    return overrides;
}

/// Searches shorten paths below the working folder, which is none of the editor's.
void make_absolute(std::vector<InputFile>& files) {
    std::error_code ignored;
    for (InputFile& file : files)
        file.path = platform::text_of(fs::absolute(platform::path_of(file.path), ignored).lexically_normal());
}

/// The editor's word for the language counts more than what the text looks like.
void apply(const Document& document, SnapshotFile& file) {
    file.text = document.text;
    file.input.asked = true;
    if (const Dialect* named = find_dialect(document.language)) {
        file.settings.dialect = named;
        file.settings.dialect_reason = "the language that the editor names";
    }
}

void move_to(std::vector<Notice>& all, std::vector<Notice> more) {
    std::ranges::move(more, std::back_inserter(all));
}

} // namespace

WorkspaceFiles::Known::Known(const std::vector<std::string>& folders)
    : settings({}, real_folders(folders))
    , isolated(no_configuration()) {
    if (folders.empty()) return;
    Discovered found = discover(folders, "", settings, {});
    Discovered context = discover_context(found.files, folders, settings, {});
    move_to(notices, std::move(found.notices));
    std::ranges::move(context.files, std::back_inserter(found.files));
    make_absolute(found.files);
    std::ranges::stable_sort(found.files, {}, &InputFile::path);
    files = snapshot_of(std::move(found.files), settings).files;
    for (std::size_t i = 0; i < files.size(); ++i) by_path.emplace(files[i].input.path, i);
}

void WorkspaceFiles::set_folders(std::vector<std::string> folders) {
    const std::lock_guard lock(mutex_);
    folders_ = std::move(folders);
    known_ = nullptr;
}

std::vector<std::string> WorkspaceFiles::folders() const {
    const std::lock_guard lock(mutex_);
    return folders_;
}

void WorkspaceFiles::forget() {
    const std::lock_guard lock(mutex_);
    known_ = nullptr;
}

bool WorkspaceFiles::has(std::string_view path) const {
    const std::lock_guard lock(mutex_);
    return std::ranges::any_of(folders_, [&](const std::string& folder) {
        return platform::lies_in(platform::path_of(path), platform::path_of(folder));
    });
}

/// With the mutex held.
std::shared_ptr<WorkspaceFiles::Known> WorkspaceFiles::known() {
    if (known_ == nullptr) {
        auto made = std::make_shared<Known>(folders_);
        if (before_ != nullptr) move_to(made->notices, std::move(before_->notices));
        before_ = known_ = std::move(made);
    }
    return known_;
}

std::optional<SnapshotFile> WorkspaceFiles::in(Known& known, const std::string& path, bool is_file) {
    if (const auto found = known.by_path.find(path); found != known.by_path.end())
        return known.files[found->second];
    auto settings = is_file ? known.settings.for_file(path) : known.isolated.for_file("untitled.nc");
    if (!settings) return std::nullopt;
    return SnapshotFile{{.path = path, .named = true}, *std::move(settings)};
}

std::optional<SnapshotFile> WorkspaceFiles::file(const Document& document) {
    const std::lock_guard lock(mutex_);
    auto found = in(*known(), document.path, document.is_file);
    if (found) apply(document, *found);
    return found;
}

std::optional<SnapshotFile> WorkspaceFiles::file(const std::string& path) {
    const std::lock_guard lock(mutex_);
    return in(*known(), path, true);
}

const std::vector<SnapshotFile>& WorkspaceFiles::around(Known& known, const std::string& path) {
    const auto [place, is_new] = known.around.try_emplace(path);
    if (!is_new) return place->second;
    Discovered context = discover_context({{.path = path, .named = true}}, {path}, known.settings, {});
    move_to(known.notices, std::move(context.notices));
    make_absolute(context.files);
    return place->second = snapshot_of(std::move(context.files), known.settings).files;
}

/// Documents that no search has found, and the programs around those that lie in none of the folders.
void WorkspaceFiles::add_elsewhere(Known& known, const std::vector<Document>& documents,
                                   Snapshot& snapshot) const {
    std::unordered_set<std::string> there;
    const auto add = [&](const SnapshotFile& file) {
        if (!known.by_path.contains(file.input.path) && there.insert(file.input.path).second)
            snapshot.files.push_back(file);
    };
    for (const Document& document : documents)
        if (auto file = in(known, document.path, document.is_file)) add(*file);
    for (const Document& document : documents) {
        const bool is_within = std::ranges::any_of(folders_, [&](const std::string& folder) {
            return platform::lies_in(platform::path_of(document.path), platform::path_of(folder));
        });
        if (document.is_file && !is_within)
            for (const SnapshotFile& file : around(known, document.path)) add(file);
    }
    std::ranges::stable_sort(snapshot.files, {},
                             [](const SnapshotFile& file) -> const std::string& { return file.input.path; });
}

Snapshot WorkspaceFiles::snapshot(const std::vector<Document>& documents, Asked asked) {
    const std::lock_guard lock(mutex_);
    const auto known_files = known();
    Snapshot snapshot{known_files->files};
    if (asked == Asked::documents)
        for (SnapshotFile& file : snapshot.files) file.input.asked = false;
    add_elsewhere(*known_files, documents, snapshot);
    std::map<std::string_view, const Document*> by_path;
    for (const Document& document : documents) by_path.emplace(document.path, &document);
    for (SnapshotFile& file : snapshot.files)
        if (const auto found = by_path.find(file.input.path); found != by_path.end())
            apply(*found->second, file);
    return snapshot;
}

std::vector<Notice> WorkspaceFiles::take_notices() {
    const std::lock_guard lock(mutex_);
    const auto known_files = known();
    auto notices = std::exchange(known_files->notices, {});
    move_to(notices, known_files->settings.take_notices());
    return notices;
}

} // namespace maclint::cli::lsp
