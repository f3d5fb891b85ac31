//! Writes all or says what went wrong; nothing raw from a program reaches a terminal.
#include "cli/terminal.hpp"

#include "cli/suggest.hpp"

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <system_error>

#include <unistd.h>

namespace maclint::cli {
namespace {

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

/// Messages of the reading layer begin with the path in quotes, which stands before them here.
std::string without_path(const Notice& notice) {
    const std::string quoted = "'" + shown(notice.path) + "' ";
    std::string message = printable(notice.message);
    return message.starts_with(quoted) ? message.substr(quoted.size()) : message;
}

} // namespace

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
    const std::unique_ptr<std::FILE, Closer> file(std::fopen(path.c_str(), "wb"));
    if (!file || !write_all(file.get(), text)) return cannot_write(path, errno);
    return std::nullopt;
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
    const bool wanted = isatty(STDOUT_FILENO) != 0 && set("NO_COLOR").empty() && set("TERM") != "dumb";
    return wanted ? Colour::coloured : Colour::plain;
}

bool error_is_terminal() { return isatty(STDERR_FILENO) != 0; }

} // namespace maclint::cli
