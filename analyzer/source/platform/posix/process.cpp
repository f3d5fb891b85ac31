//! posix_spawn and three pipes, served as they fill and empty.
#include "analyzer/source/platform/process.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <utility>

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

extern char** environ; // NOLINT(readability-redundant-declaration): not every system declares it

namespace maclint::platform {
namespace {

namespace fs = std::filesystem;

class Pipe {
  public:
    /// No end is one of the standard ones, which the other program gets anew.
    Pipe() {
        std::array<int, 2> made{};
        if (pipe(made.data()) != 0) return;
        for (std::size_t i = 0; i < made.size(); ++i) {
            ends_.at(i) = fcntl(made.at(i), F_DUPFD_CLOEXEC, STDERR_FILENO + 1);
            close(made.at(i));
        }
        if (ends_[0] >= 0 && ends_[1] >= 0) return;
        close_end(0);
        close_end(1);
    }
    Pipe(const Pipe&) = delete;
    Pipe& operator=(const Pipe&) = delete;
    ~Pipe() {
        close_end(0);
        close_end(1);
    }

    [[nodiscard]] bool is_open() const { return ends_[0] >= 0 || ends_[1] >= 0; }
    [[nodiscard]] int reader() const { return ends_[0]; }
    [[nodiscard]] int writer() const { return ends_[1]; }
    void close_reader() { close_end(0); }
    void close_writer() { close_end(1); }

  private:
    void close_end(std::size_t end) {
        const int descriptor = std::exchange(ends_.at(end), -1);
        if (descriptor >= 0) close(descriptor);
    }

    std::array<int, 2> ends_{-1, -1};
};

/// While this lives, the end of a program is kept until it is asked for: who started maclint may have ignored
/// the signal, and then the system forgets it. And a program that reads no more does not end maclint.
class OwnSignals {
  public:
    OwnSignals() {
        struct sigaction action {};
        action.sa_handler = SIG_DFL;
        sigaction(SIGCHLD, &action, &child_before_);
        action.sa_handler = SIG_IGN; // NOLINT(performance-no-int-to-ptr)
        sigaction(SIGPIPE, &action, &pipe_before_);
    }
    OwnSignals(const OwnSignals&) = delete;
    OwnSignals& operator=(const OwnSignals&) = delete;
    ~OwnSignals() {
        sigaction(SIGCHLD, &child_before_, nullptr);
        sigaction(SIGPIPE, &pipe_before_, nullptr);
    }

  private:
    struct sigaction child_before_ {};
    struct sigaction pipe_before_ {};
};

bool is_below(const fs::path& path, const fs::path& folder) {
    return std::ranges::mismatch(folder, path).in1 == folder.end();
}

/// Whether the way to a program leads through one of the folders: PATH as it is written, without its links,
/// or the program's own link.
bool leads_through(const fs::path& place, const std::vector<std::string>& folders) {
    std::error_code none;
    const std::array ways = {place.lexically_normal(), fs::canonical(place.parent_path(), none),
                             fs::canonical(place, none)};
    return std::ranges::any_of(folders, [&](const std::string& folder) {
        return std::ranges::any_of(ways, [&](const fs::path& way) { return is_below(way, folder); });
    });
}

struct FoundProgram {
    std::string place, passed_over; ///< empty: none
};

/// Where PATH has the program, by its absolute entries alone: others mean the folder that is checked.
FoundProgram find_program(const std::string& program, const std::vector<std::string>& not_below) {
    const char* const path = std::getenv("PATH"); // NOLINT(concurrency-mt-unsafe): nobody sets it
    std::string_view entries = path == nullptr ? "/usr/bin:/bin" : path;
    FoundProgram found;
    while (true) {
        const std::string_view entry = entries.substr(0, entries.find(':'));
        const fs::path place = fs::path(entry) / program;
        std::error_code none;
        if (place.is_absolute() && fs::is_regular_file(place, none) && access(place.c_str(), X_OK) == 0) {
            std::string& kept = leads_through(place, not_below) ? found.passed_over : found.place;
            if (kept.empty()) kept = place.string();
        }
        if (!found.place.empty() || entry.size() == entries.size()) return found;
        entries.remove_prefix(entry.size() + 1);
    }
}

std::string_view name_of(std::string_view variable) { return variable.substr(0, variable.find('=')); }

/// An empty path stays empty: it names nothing.
std::string with_absolute_path(const std::string& variable) {
    const fs::path path = variable.substr(std::min(variable.size(), variable.find('=') + 1));
    std::error_code error;
    const fs::path absolute = fs::absolute(path, error);
    if (path.empty() || error) return variable;
    return std::string(name_of(variable)) + "=" + absolute.string();
}

std::vector<std::string> environment_for(const ProcessRequest& request) {
    const auto is_set = [&](std::string_view name) {
        return std::ranges::any_of(request.set, [&](const auto& other) { return name_of(other) == name; });
    };
    const auto is_left_out = [&](std::string_view name) {
        return !request.left_out_prefix.empty() && name.starts_with(request.left_out_prefix) &&
               std::ranges::find(request.kept, name) == request.kept.end();
    };
    const auto is_path = [&](std::string_view name) {
        return std::ranges::find(request.paths, name) != request.paths.end();
    };
    std::vector<std::string> variables = request.set;
    for (char** at = environ; at != nullptr && *at != nullptr; ++at) {
        const std::string_view name = name_of(*at);
        if (is_set(name)) continue;
        if (is_path(name)) {
            variables.push_back(with_absolute_path(*at));
        } else if (!is_left_out(name)) {
            variables.emplace_back(*at);
        }
    }
    return variables;
}

/// Pointers to the texts, and a null behind them, as the system wants them.
std::vector<char*> pointers_to(std::vector<std::string>& texts) {
    std::vector<char*> pointers;
    for (std::string& text : texts) pointers.push_back(text.data());
    pointers.push_back(nullptr);
    return pointers;
}

struct Pipes {
    Pipe input, output, errors;

    [[nodiscard]] bool are_open() const { return input.is_open() && output.is_open() && errors.is_open(); }
};

std::optional<pid_t> spawn(const std::string& program, const ProcessRequest& request, const Pipes& pipes) {
    std::vector<std::string> words = request.words;
    std::vector<std::string> variables = environment_for(request);
    posix_spawn_file_actions_t actions{};
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, pipes.input.reader(), STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&actions, pipes.output.writer(), STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&actions, pipes.errors.writer(), STDERR_FILENO);
    posix_spawnattr_t attributes{};
    posix_spawnattr_init(&attributes);
    sigset_t usual{};
    sigemptyset(&usual);
    sigaddset(&usual, SIGPIPE); // what is ignored here would be ignored there
    posix_spawnattr_setsigdefault(&attributes, &usual);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGDEF);
    pid_t child = 0;
    const int error = posix_spawn(&child, program.c_str(), &actions, &attributes, pointers_to(words).data(),
                                  pointers_to(variables).data());
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&actions);
    return error == 0 ? std::optional(child) : std::nullopt;
}

enum class More : std::uint8_t { yes, no, not_wanted };

/// One part of what a pipe holds.
More read_part(int descriptor, const TakeOutput& take) {
    std::array<char, 65536> buffer{};
    const ssize_t got = read(descriptor, buffer.data(), buffer.size());
    if (got < 0) return errno == EINTR ? More::yes : More::no;
    if (got == 0) return More::no;
    return take({buffer.data(), static_cast<std::size_t>(got)}) ? More::yes : More::not_wanted;
}

/// Writes what the pipe takes, and says whether there is more to write.
bool write_part(int descriptor, std::string_view& rest) {
    const ssize_t written = write(descriptor, rest.data(), rest.size());
    if (written < 0) return errno == EINTR || errno == EAGAIN; // else nobody reads any more
    rest.remove_prefix(static_cast<std::size_t>(written));
    return !rest.empty();
}

/// All at once: the program waits when one of them is full.
EndedBy serve(Pipes& pipes, const ProcessRequest& request, const TakeOutput& take, std::string& text) {
    constexpr std::size_t most = 4096; // of what is wrong
    const auto keep = [&](std::string_view part) {
        text += part.substr(0, most - std::min(most, text.size()));
        return true;
    };
    std::string_view rest = request.input;
    if (rest.empty()) pipes.input.close_writer();
    using Clock = std::chrono::steady_clock;
    const auto latest = Clock::now() + request.longest;
    while (pipes.output.is_open() || pipes.errors.is_open()) {
        std::array<pollfd, 3> waiting{{{pipes.output.reader(), POLLIN, 0},
                                       {pipes.errors.reader(), POLLIN, 0},
                                       {pipes.input.writer(), POLLOUT, 0}}};
        const auto left = std::chrono::ceil<std::chrono::milliseconds>(latest - Clock::now());
        if (left.count() <= 0) return EndedBy::time;
        const int ready =
            poll(waiting.data(), waiting.size(), static_cast<int>(std::min(request.patience, left).count()));
        if (ready == 0 && left <= request.patience) return EndedBy::time;
        if (ready == 0) return EndedBy::silence;
        if (ready < 0 && errno == EINTR) continue;
        if (ready < 0) return EndedBy::silence;
        if (waiting[2].revents != 0 && !write_part(pipes.input.writer(), rest)) pipes.input.close_writer();
        if (waiting[0].revents != 0) {
            const More more = read_part(pipes.output.reader(), take);
            if (more == More::not_wanted) return EndedBy::taker;
            if (more == More::no) pipes.output.close_reader();
        }
        if (waiting[1].revents != 0 && read_part(pipes.errors.reader(), keep) == More::no)
            pipes.errors.close_reader();
    }
    return EndedBy::itself;
}

int status_of(pid_t child) {
    constexpr int unknown = 127;
    constexpr int signalled = 128;
    int status = 0;
    while (waitpid(child, &status, 0) < 0)
        if (errno != EINTR) return unknown;
    return WIFEXITED(status) ? WEXITSTATUS(status) : signalled + WTERMSIG(status);
}

} // namespace

ProcessEnd run_process(const ProcessRequest& request, const TakeOutput& take) {
    Pipes pipes;
    ProcessEnd end;
    const auto program = find_program(request.words.front(), request.not_below);
    if (program.place.empty()) end.passed_over = program.passed_over;
    if (program.place.empty() || !pipes.are_open()) return end;
    const OwnSignals signals;
    const auto child = spawn(program.place, request, pipes);
    if (!child) return end;
    pipes.input.close_reader();
    pipes.output.close_writer();
    pipes.errors.close_writer();
    fcntl(pipes.input.writer(), F_SETFL, O_NONBLOCK);
    end.by = serve(pipes, request, take, end.errors);
    if (end.by != EndedBy::itself) kill(*child, SIGKILL);
    end.status = status_of(*child);
    return end;
}

} // namespace maclint::platform
