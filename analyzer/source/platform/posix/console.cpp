//! Terminals that understand ECMA-48, and a shell that knows its work.
#include "analyzer/source/platform/console.hpp"

#include "analyzer/source/platform/posix/signals.hpp"

#include <cerrno>
#include <cstdio>

#include <sys/ioctl.h>
#include <unistd.h>

namespace maclint::platform {

std::vector<std::string> arguments(int count, char** words) {
    return {words + (count > 0 ? 1 : 0), words + count};
}

bool shell_expands_wildcards() { return true; }

Terminal terminal_at(Stream stream) {
    const bool there = isatty(stream == Stream::output ? STDOUT_FILENO : STDERR_FILENO) != 0;
    return there ? Terminal::escapes : Terminal::none;
}

std::optional<std::size_t> terminal_columns() {
    winsize size{};
    if (isatty(STDOUT_FILENO) == 0 || ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0)
        return std::nullopt;
    return size.ws_col;
}

int write(Stream stream, std::string_view text) {
    const WithoutSignal ignored(SIGXFSZ);
    std::FILE* const file = stream == Stream::output ? stdout : stderr;
    const bool written =
        std::fwrite(text.data(), 1, text.size(), file) == text.size() && std::fflush(file) == 0;
    return written ? 0 : errno;
}

} // namespace maclint::platform
