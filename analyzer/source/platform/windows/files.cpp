//! By the calls of the system: those of the standard library know no links, and no long paths.
#include "analyzer/source/platform/files.hpp"

#include "analyzer/source/platform/windows/system.hpp"

#include <optional>
#include <string_view>

namespace maclint::platform {
namespace {

namespace fs = std::filesystem;

bool is_folder(DWORD attributes) { return (attributes & FILE_ATTRIBUTE_DIRECTORY) != 0; }

/// A file and a folder have other marks of that kind, too, such as "not here but in the cloud".
bool is_link(const WIN32_FIND_DATAW& entry) {
    return (entry.dwFileAttributes & FILE_ATTRIBUTE_REPARSE_POINT) != 0 &&
           (entry.dwReserved0 == IO_REPARSE_TAG_SYMLINK || entry.dwReserved0 == IO_REPARSE_TAG_MOUNT_POINT);
}

std::optional<BY_HANDLE_FILE_INFORMATION> information_on(const fs::path& path) {
    const Handle file(open_existing(path, 0));
    BY_HANDLE_FILE_INFORMATION information{};
    if (!file.is_open() || GetFileInformationByHandle(file.get(), &information) == 0) return std::nullopt;
    return information;
}

/// `\\?\C:\shop` and `\\?\UNC\server\shop`, which the system answers with, as people write them.
std::wstring without_prefix(std::wstring_view path) {
    constexpr std::wstring_view server = LR"(\\?\UNC\)";
    constexpr std::wstring_view any = LR"(\\?\)";
    if (path.starts_with(server)) return LR"(\\)" + std::wstring(path.substr(server.size()));
    return std::wstring(path.starts_with(any) ? path.substr(any.size()) : path);
}

} // namespace

FileKind kind_of(const fs::path& path) {
    const DWORD attributes = GetFileAttributesW(extended(path).c_str());
    if (attributes == INVALID_FILE_ATTRIBUTES) return FileKind::missing;
    const Handle file(open_existing(path, 0));
    if (file.is_open()) return kind_of_open(file.get());
    if ((attributes & FILE_ATTRIBUTE_REPARSE_POINT) != 0) return FileKind::broken_link;
    return is_folder(attributes) ? FileKind::folder : FileKind::regular;
}

bool are_same_file(const fs::path& one, const fs::path& other) {
    const auto first = information_on(one);
    const auto second = information_on(other);
    return first && second && first->dwVolumeSerialNumber == second->dwVolumeSerialNumber &&
           first->nFileIndexHigh == second->nFileIndexHigh && first->nFileIndexLow == second->nFileIndexLow;
}

fs::path real_path(const fs::path& path, std::error_code& error) {
    error.clear();
    const Handle file(open_existing(path, 0));
    if (!file.is_open()) {
        error.assign(last_error(), std::generic_category());
        return {};
    }
    std::wstring real(MAX_PATH, L'\0');
    while (true) {
        const DWORD length = GetFinalPathNameByHandleW(file.get(), real.data(),
                                                       static_cast<DWORD>(real.size()), VOLUME_NAME_DOS);
        if (length == 0) return {full_path(path)}; // some network drives do not tell
        const bool fits = length < real.size();
        real.resize(length);
        if (fits) return {without_prefix(real)};
    }
}

std::uintmax_t size_of(const fs::path& path) {
    const auto information = information_on(path);
    return information ? (std::uintmax_t{information->nFileSizeHigh} << 32U) + information->nFileSizeLow : 0;
}

std::vector<FolderEntry> entries_of(const fs::path& folder, std::error_code& error) {
    error.clear();
    std::vector<FolderEntry> entries;
    WIN32_FIND_DATAW entry{};
    HANDLE search = FindFirstFileExW(extended(folder / L"*").c_str(), FindExInfoBasic, &entry,
                                     FindExSearchNameMatch, nullptr, FIND_FIRST_EX_LARGE_FETCH);
    if (search == INVALID_HANDLE_VALUE) {
        // The root of a drive may hold nothing at all, not even itself.
        if (GetLastError() != ERROR_FILE_NOT_FOUND) error.assign(last_error(), std::generic_category());
        return entries;
    }
    do {
        const std::wstring_view name = entry.cFileName;
        if (name == L"." || name == L"..") continue;
        const fs::path path = folder / name;
        const bool folder_itself = is_folder(entry.dwFileAttributes);
        const FileKind kind = is_link(entry)  ? kind_of(path)
                              : folder_itself ? FileKind::folder
                                              : FileKind::regular;
        // A link that the server of a drive, or Wine, follows by itself looks like a folder.
        const bool lies_here = !is_link(entry) && !folder_itself;
        entries.push_back({path, kind, is_link(entry), lies_here});
    } while (FindNextFileW(search, &entry) != 0);
    if (GetLastError() != ERROR_NO_MORE_FILES) error.assign(last_error(), std::generic_category());
    FindClose(search);
    return entries;
}

} // namespace maclint::platform
