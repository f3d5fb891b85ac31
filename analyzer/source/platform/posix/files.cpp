//! As the standard library has it.
#include "analyzer/source/platform/files.hpp"

#include <cstdlib>
#include <ctime>
#include <utility>

#include <sys/stat.h>
#include <unistd.h>

namespace maclint::platform {
namespace {

namespace fs = std::filesystem;

/// `is_there`: whether something bears the name, be it a link that leads nowhere.
template<class IsThere>
FileKind kind_for(fs::file_type type, IsThere is_there) {
    switch (type) {
    case fs::file_type::regular: return FileKind::regular;
    case fs::file_type::directory: return FileKind::folder;
    case fs::file_type::fifo: return FileKind::pipe;
    case fs::file_type::symlink: return FileKind::link;
    case fs::file_type::none:
    case fs::file_type::not_found: return is_there() ? FileKind::broken_link : FileKind::missing;
    default: return FileKind::other;
    }
}

/// Links, folders and files need no call of the system: the listing tells.
FileKind kind_of_entry(const fs::directory_entry& entry) {
    std::error_code ignored;
    if (entry.is_symlink(ignored)) return FileKind::link;
    if (entry.is_directory(ignored)) return FileKind::folder;
    if (entry.is_regular_file(ignored)) return FileKind::regular;
    return kind_for(entry.symlink_status(ignored).type(), [] { return true; });
}

} // namespace

FileKind kind_of(const fs::path& path) {
    std::error_code ignored;
    return kind_for(fs::status(path, ignored).type(),
                    [&] { return fs::exists(fs::symlink_status(path, ignored)); });
}

FileKind kind_unfollowed(const fs::path& path) {
    std::error_code ignored;
    return kind_for(fs::symlink_status(path, ignored).type(), [] { return false; });
}

std::optional<fs::path> link_target(const fs::path& path) {
    std::error_code error;
    fs::path target = fs::read_symlink(path, error);
    return error ? std::nullopt : std::optional(std::move(target));
}

bool lies_in(const fs::path& path, const fs::path& folder) {
    const std::string& above = folder.native();
    return path == folder || above == "/" ||
           (path.native().starts_with(above) && path.native()[above.size()] == '/');
}

bool are_same_file(const fs::path& one, const fs::path& other) {
    std::error_code none;
    return fs::equivalent(one, other, none);
}

fs::path real_path(const fs::path& path, std::error_code& error) { return fs::canonical(path, error); }

std::optional<fs::path> home_folder() {
    const char* const home = std::getenv("HOME"); // NOLINT(concurrency-mt-unsafe): nobody sets it
    return home == nullptr || *home == '\0' ? std::nullopt : std::optional<fs::path>(home);
}

std::optional<FileStamp> settled_stamp_of(const fs::path& path) {
    struct stat status {};
    timespec now{};
    if (stat(path.c_str(), &status) != 0 || clock_gettime(CLOCK_REALTIME, &now) != 0) return std::nullopt;
    constexpr time_t clock_step = 2; // seconds
    if (now.tv_sec - status.st_mtim.tv_sec <= clock_step) return std::nullopt;
    const auto nanoseconds = [](const timespec& time) {
        return std::int64_t{time.tv_sec} * 1'000'000'000 + time.tv_nsec;
    };
    return FileStamp{static_cast<std::uint64_t>(status.st_size), status.st_ino, nanoseconds(status.st_mtim),
                     nanoseconds(status.st_ctim)};
}

std::optional<Ownership> ownership_of(const fs::path& path) {
    struct stat status {};
    if (stat(path.c_str(), &status) != 0) return std::nullopt;
    return Ownership{status.st_uid, geteuid()};
}

std::uintmax_t size_of(const fs::path& path) {
    std::error_code error;
    const std::uintmax_t size = fs::file_size(path, error);
    return error ? 0 : size;
}

std::vector<FolderEntry> entries_of(const fs::path& folder, std::error_code& error) {
    std::vector<FolderEntry> entries;
    for (auto entry = fs::directory_iterator(folder, error); !error && entry != fs::directory_iterator();
         entry.increment(error)) {
        const FileKind kind = kind_of_entry(*entry);
        entries.push_back({entry->path(), kind, kind != FileKind::link});
    }
    return entries;
}

} // namespace maclint::platform
