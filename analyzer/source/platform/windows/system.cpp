//! The calls that several others need.
#include "analyzer/source/platform/windows/system.hpp"

#include <algorithm>
#include <cerrno>
#include <limits>

namespace maclint::platform {
namespace {

/// Texts of more than that are not converted: a path, a line of the console is far shorter.
int length_of(std::size_t size) {
    return static_cast<int>(std::min<std::size_t>(size, std::numeric_limits<int>::max()));
}

} // namespace

std::wstring wide(std::string_view text) {
    if (text.empty()) return {};
    const int size = length_of(text.size());
    const int length = MultiByteToWideChar(CP_UTF8, 0, text.data(), size, nullptr, 0);
    std::wstring converted(static_cast<std::size_t>(length), L'\0');
    MultiByteToWideChar(CP_UTF8, 0, text.data(), size, converted.data(), length);
    return converted;
}

std::string narrow(std::wstring_view text) {
    if (text.empty()) return {};
    const int size = length_of(text.size());
    const int length = WideCharToMultiByte(CP_UTF8, 0, text.data(), size, nullptr, 0, nullptr, nullptr);
    std::string converted(static_cast<std::size_t>(length), '\0');
    WideCharToMultiByte(CP_UTF8, 0, text.data(), size, converted.data(), length, nullptr, nullptr);
    return converted;
}

std::wstring full_path(const std::filesystem::path& path) {
    std::wstring full(MAX_PATH, L'\0');
    while (true) {
        const DWORD length =
            GetFullPathNameW(path.c_str(), static_cast<DWORD>(full.size()), full.data(), nullptr);
        if (length == 0) return path.native();
        const bool fits = length < full.size();
        full.resize(length);
        if (fits) return full;
    }
}

std::wstring extended(const std::filesystem::path& path) {
    constexpr std::size_t longest = 240; // a folder has to leave room for the names of files: MAX_PATH - 12
    const std::wstring full = full_path(path);
    if (full.size() < longest || full.starts_with(LR"(\\?\)")) return path.native();
    if (full.starts_with(LR"(\\)")) return LR"(\\?\UNC)" + full.substr(1);
    return LR"(\\?\)" + full;
}

int last_error() {
    switch (GetLastError()) {
    case ERROR_SUCCESS: return EIO; // a call that failed without a reason
    case ERROR_FILE_NOT_FOUND:
    case ERROR_PATH_NOT_FOUND:
    case ERROR_INVALID_DRIVE:
    case ERROR_INVALID_NAME: // a wildcard that nothing fits
    case ERROR_BAD_PATHNAME:
    case ERROR_BAD_NETPATH:
    case ERROR_BAD_NET_NAME: return ENOENT;
    case ERROR_DIRECTORY: return ENOTDIR;
    case ERROR_ACCESS_DENIED:
    case ERROR_WRITE_PROTECT: return EACCES;
    case ERROR_SHARING_VIOLATION:
    case ERROR_LOCK_VIOLATION:
    case ERROR_PIPE_BUSY: return EBUSY;
    case ERROR_FILENAME_EXCED_RANGE: return ENAMETOOLONG;
    case ERROR_CANT_RESOLVE_FILENAME: return ELOOP;
    case ERROR_TOO_MANY_OPEN_FILES: return EMFILE;
    case ERROR_NOT_ENOUGH_MEMORY:
    case ERROR_OUTOFMEMORY: return ENOMEM;
    case ERROR_HANDLE_DISK_FULL:
    case ERROR_DISK_FULL: return ENOSPC;
    case ERROR_FILE_EXISTS:
    case ERROR_ALREADY_EXISTS: return EEXIST;
    case ERROR_INVALID_HANDLE: return EBADF;
    case ERROR_BROKEN_PIPE:
    case ERROR_NO_DATA: return EPIPE;
    default: return EIO;
    }
}

HANDLE open_existing(const std::filesystem::path& path, DWORD rights) {
    return CreateFileW(extended(path).c_str(), rights, FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE,
                       nullptr, OPEN_EXISTING, FILE_FLAG_BACKUP_SEMANTICS, nullptr);
}

FileKind kind_of_open(HANDLE handle) {
    switch (GetFileType(handle)) {
    case FILE_TYPE_DISK: break;
    case FILE_TYPE_PIPE: return FileKind::pipe;
    default: return FileKind::other;
    }
    BY_HANDLE_FILE_INFORMATION information{};
    if (GetFileInformationByHandle(handle, &information) == 0) return FileKind::regular;
    const bool folder = (information.dwFileAttributes & FILE_ATTRIBUTE_DIRECTORY) != 0;
    return folder ? FileKind::folder : FileKind::regular;
}

int write_all(HANDLE handle, std::string_view bytes) {
    constexpr std::size_t most = std::size_t{1} << 20U; // pipes take no more at once
    while (!bytes.empty()) {
        DWORD written = 0;
        const auto part = static_cast<DWORD>(std::min(bytes.size(), most));
        if (WriteFile(handle, bytes.data(), part, &written, nullptr) == 0) return last_error();
        if (written == 0) return EIO; // a pipe that neither waits nor takes anything
        bytes.remove_prefix(written);
    }
    return 0;
}

} // namespace maclint::platform
