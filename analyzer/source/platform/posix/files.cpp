//! As the standard library has it.
#include "analyzer/source/platform/files.hpp"

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
    case fs::file_type::none:
    case fs::file_type::not_found: return is_there() ? FileKind::broken_link : FileKind::missing;
    default: return FileKind::other;
    }
}

/// Folders and files need no call of the system: the listing tells.
FileKind kind_of_entry(const fs::directory_entry& entry) {
    std::error_code ignored;
    if (entry.is_directory(ignored)) return FileKind::folder;
    if (entry.is_regular_file(ignored)) return FileKind::regular;
    return kind_for(entry.status(ignored).type(), [] { return true; });
}

} // namespace

FileKind kind_of(const fs::path& path) {
    std::error_code ignored;
    return kind_for(fs::status(path, ignored).type(),
                    [&] { return fs::exists(fs::symlink_status(path, ignored)); });
}

bool are_same_file(const fs::path& one, const fs::path& other) {
    std::error_code none;
    return fs::equivalent(one, other, none);
}

fs::path real_path(const fs::path& path, std::error_code& error) { return fs::canonical(path, error); }

std::uintmax_t size_of(const fs::path& path) {
    std::error_code error;
    const std::uintmax_t size = fs::file_size(path, error);
    return error ? 0 : size;
}

std::vector<FolderEntry> entries_of(const fs::path& folder, std::error_code& error) {
    std::vector<FolderEntry> entries;
    for (auto entry = fs::directory_iterator(folder, error); !error && entry != fs::directory_iterator();
         entry.increment(error)) {
        std::error_code ignored;
        const bool is_link = entry->is_symlink(ignored);
        entries.push_back({entry->path(), kind_of_entry(*entry), is_link, !is_link});
    }
    return entries;
}

} // namespace maclint::platform
