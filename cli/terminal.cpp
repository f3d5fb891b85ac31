//! Writes all or says what went wrong; nothing raw from a program reaches a terminal.
#include "cli/terminal.hpp"

#include "cli/suggest.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <system_error>

#include <sys/ioctl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace maclint::cli {
namespace {

namespace fs = std::filesystem;

void print_line(std::string_view kind, const std::string& text) {
    std::fputs(("maclint: " + std::string(kind) + ": " + text + "\n").c_str(), stderr);
}

Notice cannot_write(const std::string& path, int error) {
    const std::string name = path == "-" ? "standard output" : path;
    return {NoticeKind::unreadable, name,
            "cannot be written: the system says '" + std::generic_category().message(error) +
                "'. Check the folder, its permissions and the space that is left."};
}

bool write_all(std::FILE* file, std::string_view text) {
    return std::fwrite(text.data(), 1, text.size(), file) == text.size() && std::fflush(file) == 0;
}

struct Closer {
    void operator()(std::FILE* file) const { std::fclose(file); }
};

bool write_in_place(const std::string& path, std::string_view text) {
    const std::unique_ptr<std::FILE, Closer> file(std::fopen(path.c_str(), "wb"));
    return file && write_all(file.get(), text);
}

/// The rights that fopen would give a new file, or those of the file that is replaced.
mode_t mode_for(const std::string& path) {
    struct stat old {};
    if (stat(path.c_str(), &old) == 0) return old.st_mode & 07777U;
    const mode_t mask = umask(0);
    umask(mask);
    return 0666U & ~mask;
}

/// Whoever stops the run, or a full disk, leaves the old file as it was.
bool replace(const std::string& path, std::string_view text) {
    if (access(path.c_str(), F_OK) == 0 && access(path.c_str(), W_OK) != 0) return false;
    std::string temporary = path + ".XXXXXX";
    const int descriptor = mkstemp(temporary.data());
    if (descriptor < 0) return false;
    const std::unique_ptr<std::FILE, Closer> file(fdopen(descriptor, "wb"));
    if (file && fchmod(descriptor, mode_for(path)) == 0 && write_all(file.get(), text) &&
        fsync(descriptor) == 0 && std::rename(temporary.c_str(), path.c_str()) == 0)
        return true;
    const int error = errno;
    unlink(temporary.c_str());
    errno = error;
    return false;
}

/// Where the links lead, so that a report replaces no link; pipes and devices are written as they are.
bool write_file(const std::string& path, std::string_view text) {
    std::error_code none;
    if (fs::exists(path, none) && !fs::is_regular_file(path, none)) return write_in_place(path, text);
    const fs::path target = fs::weakly_canonical(path, none);
    return replace(none || target.empty() ? path : target.string(), text);
}

/// Messages of the reading layer begin with the path in quotes, which stands before them here.
std::string without_path(const Notice& notice) {
    const std::string quoted = "'" + shown(notice.path) + "' ";
    std::string message = printable(notice.message);
    return message.starts_with(quoted) ? message.substr(quoted.size()) : message;
}

} // namespace

void print_aside(std::string_view lines) { std::fputs(std::string(lines).c_str(), stderr); }

void print_error(std::string_view message) { print_line("error", shown(message)); }

void print_notice(const Notice& notice) {
    const std::string place = notice.path.empty() ? "" : shown(notice.path) + ": ";
    print_line(notice.is_error() ? "error" : "note", place + without_path(notice));
}

int print_text(std::string_view text) {
    if (const auto failure = write_to("-", text)) {
        print_notice(*failure);
        return exit_error;
    }
    return exit_clean;
}

std::optional<Notice> write_to(const std::string& path, std::string_view text) {
    if (path == "-") return write_all(stdout, text) ? std::nullopt : std::optional(cannot_write(path, errno));
    return write_file(path, text) ? std::nullopt : std::optional(cannot_write(path, errno));
}

Colour colour_for_output(ColourChoice choice) {
    const auto set = [](const char* name) {
        const char* value = std::getenv(name); // NOLINT(concurrency-mt-unsafe): nobody writes the environment
        return value != nullptr && *value != '\0' ? std::string(value) : std::string();
    };
    switch (choice) {
    case ColourChoice::always: return Colour::coloured;
    case ColourChoice::never: return Colour::plain;
    case ColourChoice::automatic: break;
    }
    const bool wanted = output_is_terminal() && set("NO_COLOR").empty() && set("TERM") != "dumb";
    return wanted ? Colour::coloured : Colour::plain;
}

bool output_is_terminal() { return isatty(STDOUT_FILENO) != 0; }

std::size_t output_width() {
    winsize size{};
    if (!output_is_terminal() || ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0)
        return usual_width;
    constexpr std::size_t least = 40;
    constexpr std::size_t most = 120; // longer lines are hard to read
    return std::clamp<std::size_t>(size.ws_col, least, most);
}

bool error_is_terminal() { return isatty(STDERR_FILENO) != 0; }

} // namespace maclint::cli
