//! A new file is written beside the old one and takes its name; Ctrl-C in between takes it away.
#include "analyzer/source/platform/output.hpp"

#include "analyzer/source/platform/files.hpp"
#include "analyzer/source/platform/paths.hpp"
#include "analyzer/source/platform/windows/system.hpp"

#include <atomic>
#include <cerrno>

namespace maclint::platform {
namespace {

namespace fs = std::filesystem;

/// What the handler of Ctrl-C, which runs on a thread of its own, may look at.
std::atomic<const wchar_t*> unfinished = nullptr;

BOOL WINAPI end_by_console(DWORD) {
    remove_unfinished();
    return FALSE; // and the run ends as it would have
}

/// While this lives, what ends the run takes the file away first.
class Unfinished {
  public:
    explicit Unfinished(const std::wstring& name) {
        unfinished = name.c_str();
        SetConsoleCtrlHandler(end_by_console, TRUE);
    }
    Unfinished(const Unfinished&) = delete;
    Unfinished& operator=(const Unfinished&) = delete;
    ~Unfinished() {
        SetConsoleCtrlHandler(end_by_console, FALSE);
        unfinished = nullptr;
    }
};

/// A name that nobody else takes: of this process and this moment.
std::wstring name_beside(const fs::path& path) {
    return extended(path.native() + L"." + std::to_wstring(GetCurrentProcessId()) + L"-" +
                    std::to_wstring(GetTickCount64()));
}

bool is_read_only(const std::wstring& path) {
    const DWORD attributes = GetFileAttributesW(path.c_str());
    return attributes != INVALID_FILE_ATTRIBUTES && (attributes & FILE_ATTRIBUTE_READONLY) != 0;
}

/// Writes the new file and closes it.
int write_new(const std::wstring& name, std::string_view text) {
    const Handle file(CreateFileW(name.c_str(), GENERIC_WRITE, FILE_SHARE_DELETE, nullptr, CREATE_NEW,
                                  FILE_ATTRIBUTE_NORMAL, nullptr));
    if (!file.is_open()) return last_error();
    if (const int error = write_all(file.get(), text)) return error;
    return FlushFileBuffers(file.get()) == 0 ? last_error() : 0;
}

} // namespace

fs::path place_of(const fs::path& path) {
    std::error_code error;
    const fs::path target = fs::absolute(path, error).lexically_normal();
    if (error) return path;
    fs::path real = real_path(target, error);
    if (!error) return real;
    const fs::path folder = real_path(target.parent_path(), error);
    return error ? target : folder / target.filename();
}

std::string written_path(const std::string& path) { return text_of(place_of(path_of(path))); }

int replace_file(const std::string& path, std::string_view text) {
    const fs::path target = path_of(path);
    const std::wstring name = extended(target);
    if (is_read_only(name)) return EACCES;
    if (kind_of(target) == FileKind::broken_link)
        return ENOENT; // whoever made the link wants no file in its place
    const std::wstring temporary = name_beside(target);
    const Unfinished guarded(temporary);
    int error = write_new(temporary, text);
    if (error == 0 && MoveFileExW(temporary.c_str(), name.c_str(), MOVEFILE_REPLACE_EXISTING) == 0)
        error = last_error();
    if (error != 0) DeleteFileW(temporary.c_str());
    return error;
}

void remove_unfinished() noexcept {
    if (const wchar_t* name = unfinished.load()) DeleteFileW(name);
}

int write_in_place(const std::string& path, std::string_view text) {
    const fs::path target = path_of(path);
    if (kind_of(target) == FileKind::folder) return EISDIR;
    const Handle file(open_existing(target, GENERIC_WRITE));
    return file.is_open() ? write_all(file.get(), text) : last_error();
}

bool names_open_file(const std::string&) { return false; }

bool names_standard_output(const std::string&) { return false; }

bool is_standard_output(const std::string& path) {
    BY_HANDLE_FILE_INFORMATION output{};
    BY_HANDLE_FILE_INFORMATION other{};
    const Handle file(open_existing(path_of(path), 0));
    return file.is_open() && GetFileType(file.get()) == FILE_TYPE_DISK &&
           GetFileInformationByHandle(GetStdHandle(STD_OUTPUT_HANDLE), &output) != 0 &&
           GetFileInformationByHandle(file.get(), &other) != 0 &&
           output.dwVolumeSerialNumber == other.dwVolumeSerialNumber &&
           output.nFileIndexHigh == other.nFileIndexHigh && output.nFileIndexLow == other.nFileIndexLow;
}

} // namespace maclint::platform
