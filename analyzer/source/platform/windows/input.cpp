//! Bytes as they are: no line ends are changed, and ^Z ends nothing.
#include "analyzer/source/platform/input.hpp"

#include "analyzer/source/platform/paths.hpp"
#include "analyzer/source/platform/windows/system.hpp"

#include <algorithm>
#include <cerrno>
#include <thread>

#include <fcntl.h>
#include <io.h>

namespace maclint::platform {
namespace {

constexpr int standard_input_descriptor = 0;

HANDLE handle_of(int descriptor) {
    // NOLINTNEXTLINE(performance-no-int-to-ptr): the C library gives handles as numbers
    return reinterpret_cast<HANDLE>(_get_osfhandle(descriptor));
}

Portion read_once(int descriptor, std::span<char> bytes) {
    constexpr std::size_t most = std::size_t{1} << 30U;
    DWORD count = 0;
    if (ReadFile(handle_of(descriptor), bytes.data(), static_cast<DWORD>(std::min(bytes.size(), most)),
                 &count, nullptr) != 0)
        return {count, 0};
    const DWORD error = GetLastError();
    const bool ended = error == ERROR_BROKEN_PIPE || error == ERROR_HANDLE_EOF;
    return {0, ended ? 0 : last_error()};
}

} // namespace

OpenFile::OpenFile(const std::string& path) {
    Handle file(open_existing(path_of(path), GENERIC_READ));
    if (!file.is_open()) {
        error_ = last_error();
        return;
    }
    BY_HANDLE_FILE_INFORMATION information{};
    if (GetFileInformationByHandle(file.get(), &information) != 0)
        size_ = (std::uintmax_t{information.nFileSizeHigh} << 32U) + information.nFileSizeLow;
    kind_ = kind_of_open(file.get());
    descriptor_ = _open_osfhandle(reinterpret_cast<std::intptr_t>(file.get()), _O_RDONLY | _O_BINARY);
    if (descriptor_ < 0)
        error_ = errno;
    else
        file.release();
}

OpenFile::OpenFile(StandardInput /*which*/)
    : descriptor_(standard_input_descriptor)
    , kind_(kind_of_open(handle_of(descriptor_))) {}

OpenFile::~OpenFile() {
    if (descriptor_ > standard_input_descriptor) _close(descriptor_);
}

/// Files of a server end with an error when it is silent: the system has a patience of its own.
std::optional<Portion> OpenFile::read_some(std::span<char> bytes, std::chrono::milliseconds patience) {
    if (!comes_in_time(descriptor_, patience)) return std::nullopt;
    return read_once(descriptor_, bytes);
}

bool comes_in_time(int descriptor, std::chrono::milliseconds patience) {
    HANDLE const handle = handle_of(descriptor);
    if (GetFileType(handle) != FILE_TYPE_PIPE) return true;
    const auto end = std::chrono::steady_clock::now() + patience;
    for (auto pause = std::chrono::milliseconds(1);; pause = std::chrono::milliseconds(10)) {
        DWORD waiting = 0;
        const bool open = PeekNamedPipe(handle, nullptr, 0, nullptr, &waiting, nullptr) != 0;
        if (!open || waiting != 0) return true; // reading tells what has ended it
        if (std::chrono::steady_clock::now() >= end) return false;
        std::this_thread::sleep_for(pause);
    }
}

} // namespace maclint::platform
