//! posix_spawn and two pipes, read as they fill.
#include "analyzer/source/platform/process.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
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

class Pipe {
  public:
    Pipe() {
        if (pipe(ends_.data()) != 0) ends_ = {-1, -1};
        for (const int end : ends_) // pipe2 would do both, but not every system has it
            if (end >= 0) fcntl(end, F_SETFD, FD_CLOEXEC);
    }
    Pipe(const Pipe&) = delete;
    Pipe& operator=(const Pipe&) = delete;
    ~Pipe() {
        close_end(0);
        close_end(1);
    }

    [[nodiscard]] bool is_open() const { return ends_[0] >= 0; }
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

/// While this lives, the end of a program is kept until it is asked for. Who started maclint may have ignored
/// the signal, and then the system forgets it.
class KeptEnds {
  public:
    KeptEnds() {
        struct sigaction action {};
        action.sa_handler = SIG_DFL;
        sigaction(SIGCHLD, &action, &before_);
    }
    KeptEnds(const KeptEnds&) = delete;
    KeptEnds& operator=(const KeptEnds&) = delete;
    ~KeptEnds() { sigaction(SIGCHLD, &before_, nullptr); }

  private:
    struct sigaction before_ {};
};

std::optional<pid_t> spawn(const std::vector<std::string>& words, const Pipe& output, const Pipe& errors) {
    std::vector<std::string> copies = words;
    std::vector<char*> pointers;
    for (std::string& word : copies) pointers.push_back(word.data());
    pointers.push_back(nullptr);
    posix_spawn_file_actions_t actions{};
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_adddup2(&actions, output.writer(), STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&actions, errors.writer(), STDERR_FILENO);
    pid_t child = 0;
    const int error = posix_spawnp(&child, pointers.front(), &actions, nullptr, pointers.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    return error == 0 ? std::optional(child) : std::nullopt;
}

/// One part of what a pipe holds; false: there is nothing more.
bool read_part(int descriptor, const std::function<void(std::string_view)>& take) {
    std::array<char, 65536> buffer{};
    const ssize_t got = read(descriptor, buffer.data(), buffer.size());
    if (got < 0) return errno == EINTR;
    take({buffer.data(), static_cast<std::size_t>(got)});
    return got > 0;
}

/// Both at once: the program waits when one of them is full.
void drain(Pipe& output, Pipe& errors, const std::function<void(std::string_view)>& take, std::string& text) {
    constexpr std::size_t most = 4096; // of what is wrong
    const auto keep = [&](std::string_view part) {
        text += part.substr(0, most - std::min(most, text.size()));
    };
    while (output.is_open() || errors.is_open()) {
        std::array<pollfd, 2> waiting{{{output.reader(), POLLIN, 0}, {errors.reader(), POLLIN, 0}}};
        if (poll(waiting.data(), waiting.size(), -1) < 0 && errno != EINTR) return;
        if (waiting[0].revents != 0 && !read_part(output.reader(), take)) output.close_reader();
        if (waiting[1].revents != 0 && !read_part(errors.reader(), keep)) errors.close_reader();
    }
}

} // namespace

ProcessEnd run_process(const std::vector<std::string>& words,
                       const std::function<void(std::string_view part)>& take) {
    Pipe output;
    Pipe errors;
    ProcessEnd end;
    if (!output.is_open() || !errors.is_open()) return end;
    const KeptEnds kept;
    const auto child = spawn(words, output, errors);
    if (!child) return end;
    end.started = true;
    output.close_writer();
    errors.close_writer();
    drain(output, errors, take, end.errors);
    int status = 0;
    constexpr int unknown = 127;
    constexpr int signalled = 128;
    while (waitpid(*child, &status, 0) < 0) {
        if (errno == EINTR) continue;
        end.status = unknown;
        return end;
    }
    end.status = WIFEXITED(status) ? WEXITSTATUS(status) : signalled + WTERMSIG(status);
    return end;
}

} // namespace maclint::platform
