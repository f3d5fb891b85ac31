//! What the files of this folder share: UTF-16, handles, numbers of errors.
#pragma once

#include "analyzer/source/platform/files.hpp"

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>

#ifndef NOMINMAX
#define NOMINMAX
#endif
#define WIN32_LEAN_AND_MEAN
#include <windows.h>

namespace maclint::platform {

/// What is no UTF-8 or UTF-16 becomes U+FFFD, so that a name is not found rather than that maclint ends.
[[nodiscard]] std::wstring wide(std::string_view text);
[[nodiscard]] std::string narrow(std::wstring_view text);

/// Absolute, without "." and "..", whatever is there.
[[nodiscard]] std::wstring full_path(const std::filesystem::path& path);

/// The path as calls of the system want it: of more than some 250 characters they only take those that begin
/// with `\\?\`, which have to be absolute and without "..".
[[nodiscard]] std::wstring extended(const std::filesystem::path& path);

/// The last error of the system, as errno has it.
[[nodiscard]] int last_error();

/// Closes itself.
class Handle {
  public:
    explicit Handle(HANDLE handle)
        : handle_(handle) {}
    Handle(const Handle&) = delete;
    Handle& operator=(const Handle&) = delete;
    ~Handle() { close(); }

    [[nodiscard]] bool is_open() const { return handle_ != INVALID_HANDLE_VALUE; }
    [[nodiscard]] HANDLE get() const { return handle_; }
    void close() {
        if (is_open()) CloseHandle(handle_);
        handle_ = INVALID_HANDLE_VALUE;
    }
    /// Somebody else closes it.
    HANDLE release() { return std::exchange(handle_, INVALID_HANDLE_VALUE); }

  private:
    HANDLE handle_;
};

/// Opens what is there, a folder, too; others may go on to read, write and remove it. 0 rights are enough to
/// look at it.
[[nodiscard]] HANDLE open_existing(const std::filesystem::path& path, DWORD rights);

/// "NUL" is a device, whatever its attributes.
[[nodiscard]] FileKind kind_of_open(HANDLE handle);

/// Writes all of it: 0, or what errno has for the failure.
[[nodiscard]] int write_all(HANDLE handle, std::string_view bytes);

} // namespace maclint::platform
