//! Says what went wrong; nothing raw from a program reaches a terminal.
#include "cli/terminal.hpp"

#include "analyzer/source/encoding.hpp"
#include "analyzer/source/platform/console.hpp"
#include "cli/text/shown.hpp"
#include "cli/written_file.hpp"

#include <algorithm>
#include <cstdlib>

namespace maclint::cli {
namespace {

Notice cannot_write(const std::string& path, const std::string& why) {
    return {NoticeKind::unreadable, path == "-" ? "standard output" : path, "cannot be written: " + why};
}

/// A message may quote what a file holds, and that may be long.
std::string shortened(const std::string& message) {
    constexpr std::size_t longest = 1000;
    constexpr std::size_t part = 400;
    if (message.size() <= longest) return message;
    const auto boundary = [&](std::size_t at) { return character_begin(message, at, Encoding::utf8); };
    return message.substr(0, boundary(part)) + " … " + message.substr(boundary(message.size() - part));
}

void print_line(std::string_view kind, const std::string& text) {
    print_aside("maclint: " + std::string(kind) + ": " + shortened(text) + "\n");
}

/// Messages of the reading layer begin with the path in quotes, which stands before them here.
std::string without_path(const Notice& notice) {
    const std::string quoted = "'" + shown(notice.path) + "' ";
    std::string message = printable(notice.message);
    return message.starts_with(quoted) ? message.substr(quoted.size()) : message;
}

} // namespace

void print_aside(std::string_view lines) {
    static_cast<void>(platform::write(platform::Stream::error, lines)); // there is nobody else to tell
}

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
    const auto failure = path == "-" ? write_output(text) : write_file(path, text);
    return failure ? std::optional(cannot_write(path, *failure)) : std::nullopt;
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
    const bool understood = platform::terminal_at(platform::Stream::output) == platform::Terminal::escapes;
    const bool wanted = understood && set("NO_COLOR").empty() && set("TERM") != "dumb";
    return wanted ? Colour::coloured : Colour::plain;
}

bool output_is_terminal() {
    return platform::terminal_at(platform::Stream::output) != platform::Terminal::none;
}

std::size_t output_width() {
    const auto columns = platform::terminal_columns();
    if (!columns) return usual_width;
    return std::clamp(*columns, least_width, most_width);
}

bool error_shows_progress() {
    return platform::terminal_at(platform::Stream::error) == platform::Terminal::escapes;
}

} // namespace maclint::cli
