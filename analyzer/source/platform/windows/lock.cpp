//! A file that nobody else may open, and that goes with its last handle.
#include "analyzer/source/platform/lock.hpp"

#include "analyzer/source/platform/paths.hpp"
#include "analyzer/source/platform/windows/system.hpp"

#include <cerrno>

namespace maclint::platform {
namespace {

HANDLE open_lock(const std::wstring& name) {
    return CreateFileW(name.c_str(), GENERIC_READ | GENERIC_WRITE | DELETE, 0, nullptr, OPEN_ALWAYS,
                       FILE_ATTRIBUTE_NORMAL | FILE_FLAG_OPEN_REPARSE_POINT, nullptr);
}

bool is_lock(HANDLE handle) {
    BY_HANDLE_FILE_INFORMATION information{};
    return GetFileInformationByHandle(handle, &information) != 0 && information.nFileSizeHigh == 0 &&
           information.nFileSizeLow == 0 &&
           (information.dwFileAttributes & (FILE_ATTRIBUTE_REPARSE_POINT | FILE_ATTRIBUTE_DIRECTORY)) == 0;
}

/// However the run ends, the name goes with the handle.
void remove_when_closed(HANDLE handle) {
    FILE_DISPOSITION_INFO gone{};
    gone.DeleteFile = TRUE;
    SetFileInformationByHandle(handle, FileDispositionInfo, &gone, sizeof gone);
}

/// Somebody else holds it, or it is just going: that is what access is denied for as well.
bool is_held_by_others(DWORD error) {
    return error == ERROR_SHARING_VIOLATION || error == ERROR_ACCESS_DENIED || error == ERROR_DELETE_PENDING;
}

} // namespace

struct WriteLock::Held {
    explicit Held(HANDLE opened)
        : handle(opened) {}
    Handle handle;
};

std::string lock_name(const std::string& path) { return path + ".lock"; }

WriteLock::WriteLock(const std::string& path) {
    const std::wstring name = extended(path_of(lock_name(path)));
    const ULONGLONG end = GetTickCount64() + std::chrono::milliseconds(patience_with_writers).count();
    while (true) {
        HANDLE handle = open_lock(name);
        if (handle != INVALID_HANDLE_VALUE) {
            held_ = std::make_unique<Held>(handle);
            if (is_lock(handle)) {
                remove_when_closed(handle);
                return;
            }
            held_.reset();
            error_ = EEXIST;
            return;
        }
        const DWORD reason = GetLastError();
        if (!is_held_by_others(reason) || GetTickCount64() >= end) {
            error_ = reason == ERROR_SHARING_VIOLATION ? EBUSY : last_error();
            return;
        }
        Sleep(10);
    }
}

WriteLock::~WriteLock() = default;

} // namespace maclint::platform
