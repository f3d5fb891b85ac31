//! The console is given UTF-16, so that its code page does not matter, and is left as it was found but for
//! its understanding of escape sequences.
#include "analyzer/source/platform/console.hpp"

#include "analyzer/source/platform/windows/system.hpp"

#include <algorithm>
#include <cerrno>

#include <shellapi.h>

namespace maclint::platform {
namespace {

HANDLE handle_of(Stream stream) {
    return GetStdHandle(stream == Stream::output ? STD_OUTPUT_HANDLE : STD_ERROR_HANDLE);
}

int write_to_console(HANDLE console, std::wstring_view text) {
    constexpr std::size_t most = 8192; // older consoles take no more than 64 KiB at once
    while (!text.empty()) {
        std::size_t part = std::min(text.size(), most);
        if (part < text.size() && IS_HIGH_SURROGATE(text[part - 1])) --part;
        DWORD written = 0;
        if (WriteConsoleW(console, text.data(), static_cast<DWORD>(part), &written, nullptr) == 0 ||
            written == 0)
            return last_error();
        text.remove_prefix(written);
    }
    return 0;
}

} // namespace

std::vector<std::string> arguments(int, char**) {
    int count = 0;
    wchar_t** const words = CommandLineToArgvW(GetCommandLineW(), &count);
    std::vector<std::string> result;
    for (int i = 1; i < count; ++i) {
        std::wstring word = words[i];
        // "D:\shop\" as people type it: the system takes the last backslash and the quote for a quote.
        // Without its backslash, "D:\" would be the current folder of the drive.
        if (word.ends_with(L'"')) word.back() = L'\\';
        result.push_back(narrow(word));
    }
    LocalFree(words);
    return result;
}

bool shell_expands_wildcards() { return false; }

Terminal terminal_at(Stream stream) {
    HANDLE const console = handle_of(stream);
    DWORD mode = 0;
    if (GetConsoleMode(console, &mode) == 0) return Terminal::none;
    const DWORD wanted = mode | ENABLE_PROCESSED_OUTPUT | ENABLE_VIRTUAL_TERMINAL_PROCESSING;
    return mode == wanted || SetConsoleMode(console, wanted) != 0 ? Terminal::escapes : Terminal::plain;
}

std::optional<std::size_t> terminal_columns() {
    CONSOLE_SCREEN_BUFFER_INFO information{};
    if (GetConsoleScreenBufferInfo(handle_of(Stream::output), &information) == 0) return std::nullopt;
    return static_cast<std::size_t>(information.srWindow.Right - information.srWindow.Left + 1);
}

int write(Stream stream, std::string_view text) {
    HANDLE const handle = handle_of(stream);
    if (handle == nullptr || handle == INVALID_HANDLE_VALUE) return EBADF;
    DWORD mode = 0;
    return GetConsoleMode(handle, &mode) != 0 ? write_to_console(handle, wide(text))
                                              : write_all(handle, text);
}

} // namespace maclint::platform
