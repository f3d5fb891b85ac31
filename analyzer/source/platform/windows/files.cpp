//! By the calls of the system: those of the standard library know no links, and no long paths.
#include "analyzer/source/platform/files.hpp"

#include "analyzer/source/platform/windows/system.hpp"

#include <cstring>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include <winioctl.h>

namespace maclint::platform {
namespace {

namespace fs = std::filesystem;

bool is_folder(DWORD attributes) { return (attributes & FILE_ATTRIBUTE_DIRECTORY) != 0; }

/// Symbolic links, junctions and all else that stands for a name elsewhere, such as a link of WSL. A file and
/// a folder have other marks of that kind, too, such as "not here but in the cloud".
bool is_link(DWORD attributes, DWORD tag) {
    return (attributes & FILE_ATTRIBUTE_REPARSE_POINT) != 0 && IsReparseTagNameSurrogate(tag);
}

/// What the listing of its folder says of a file.
std::optional<WIN32_FIND_DATAW> listed(const fs::path& path) {
    WIN32_FIND_DATAW entry{};
    HANDLE search =
        FindFirstFileExW(extended(path).c_str(), FindExInfoBasic, &entry, FindExSearchNameMatch, nullptr, 0);
    if (search == INVALID_HANDLE_VALUE) return std::nullopt;
    FindClose(search);
    return entry;
}

FileKind kind_of_entry(const WIN32_FIND_DATAW& entry) {
    if (is_link(entry.dwFileAttributes, entry.dwReserved0)) return FileKind::link;
    return is_folder(entry.dwFileAttributes) ? FileKind::folder : FileKind::regular;
}

/// The head of what a symbolic link or a junction holds (REPARSE_DATA_BUFFER, which only drivers' headers
/// declare); names follow, at offsets in bytes.
struct LinkData {
    DWORD tag;
    WORD length, reserved;
    WORD target_offset, target_length, shown_offset, shown_length;
};

/// Of `\??\C:\shop` and `\??\UNC\server\shop`, as the system keeps targets. A volume without a letter stays
/// what it is, which is in no folder.
std::wstring as_path(std::wstring_view target) {
    constexpr std::wstring_view server = LR"(\??\UNC\)";
    constexpr std::wstring_view any = LR"(\??\)";
    if (target.starts_with(server)) return LR"(\\)" + std::wstring(target.substr(server.size()));
    if (target.starts_with(any) && target.size() > any.size() + 1 && target[any.size() + 1] == L':')
        return std::wstring(target.substr(any.size()));
    return target.starts_with(any) ? LR"(\\?\)" + std::wstring(target.substr(any.size()))
                                   : std::wstring(target);
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

FileKind kind_unfollowed(const fs::path& path) {
    const auto entry = listed(path);
    return entry ? kind_of_entry(*entry) : FileKind::missing;
}

std::optional<fs::path> link_target(const fs::path& path) {
    const auto entry = listed(path);
    if (!entry || kind_of_entry(*entry) != FileKind::link) return std::nullopt;
    const fs::path nowhere(LR"(\\?\)");
    const Handle link(CreateFileW(
        extended(path).c_str(), 0, FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE, nullptr,
        OPEN_EXISTING, FILE_FLAG_BACKUP_SEMANTICS | FILE_FLAG_OPEN_REPARSE_POINT, nullptr));
    std::vector<char> data(MAXIMUM_REPARSE_DATA_BUFFER_SIZE);
    DWORD size = 0;
    if (!link.is_open() || DeviceIoControl(link.get(), FSCTL_GET_REPARSE_POINT, nullptr, 0, data.data(),
                                           static_cast<DWORD>(data.size()), &size, nullptr) == 0)
        return nowhere;
    LinkData head{};
    std::memcpy(&head, data.data(), sizeof head);
    const bool is_symbolic = head.tag == IO_REPARSE_TAG_SYMLINK;
    if (!is_symbolic && head.tag != IO_REPARSE_TAG_MOUNT_POINT) return nowhere;
    const std::size_t begin = sizeof head + (is_symbolic ? sizeof(DWORD) : 0) + head.target_offset;
    if (begin + head.target_length > size) return nowhere;
    std::wstring target(head.target_length / sizeof(wchar_t), L'\0');
    std::memcpy(target.data(), data.data() + begin, target.size() * sizeof(wchar_t));
    return fs::path(as_path(target));
}

bool lies_in(const fs::path& path, const fs::path& folder) {
    const std::wstring& above = folder.native();
    const std::wstring& whole = path.native();
    if (whole.size() < above.size()) return false;
    const bool begins_alike =
        CompareStringOrdinal(whole.c_str(), static_cast<int>(above.size()), above.c_str(),
                             static_cast<int>(above.size()), TRUE) == CSTR_EQUAL;
    const auto is_separator = [](wchar_t c) { return c == L'\\' || c == L'/'; };
    return begins_alike && (whole.size() == above.size() || (!above.empty() && is_separator(above.back())) ||
                            is_separator(whole[above.size()]));
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

std::optional<fs::path> home_folder() {
    const wchar_t* const home = _wgetenv(L"USERPROFILE");
    return home == nullptr || *home == L'\0' ? std::nullopt : std::optional<fs::path>(home);
}

std::optional<FileStamp> settled_stamp_of(const fs::path& path) {
    const auto information = information_on(path);
    if (!information) return std::nullopt;
    const auto whole = [](DWORD high, DWORD low) { return (std::uint64_t{high} << 32U) + low; };
    const auto steps = [&](const FILETIME& time) {
        return static_cast<std::int64_t>(whole(time.dwHighDateTime, time.dwLowDateTime));
    };
    FILETIME now{};
    GetSystemTimeAsFileTime(&now);
    constexpr std::int64_t clock_step = 20'000'000; // 100 ns
    if (steps(now) - steps(information->ftLastWriteTime) <= clock_step) return std::nullopt;
    return FileStamp{whole(information->nFileSizeHigh, information->nFileSizeLow),
                     whole(information->nFileIndexHigh, information->nFileIndexLow),
                     steps(information->ftLastWriteTime), 0};
}

std::optional<Ownership> ownership_of(const fs::path&) { return std::nullopt; }

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
        const FileKind kind = kind_of_entry(entry);
        // A link that the server of a drive, or Wine, follows by itself looks like a folder. One to a file
        // looks like a file: to ask for each would take too long.
        entries.push_back({folder / name, kind, kind == FileKind::regular});
    } while (FindNextFileW(search, &entry) != 0);
    if (GetLastError() != ERROR_NO_MORE_FILES) error.assign(last_error(), std::generic_category());
    FindClose(search);
    return entries;
}

} // namespace maclint::platform
