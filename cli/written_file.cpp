//! A new file is written beside the old one and takes its name; a signal in between takes it away.
#include "cli/written_file.hpp"

#include <array>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <system_error>
#include <thread>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace maclint::cli {
namespace {

namespace fs = std::filesystem;

/// How long a pipe may be without a reader.
constexpr std::chrono::seconds patience{10};

std::string refusal(int error) {
    return "the system says '" + std::generic_category().message(error) +
           "'. Check the folder, its permissions and the space that is left.";
}

bool write_all(std::FILE* file, std::string_view text) {
    return std::fwrite(text.data(), 1, text.size(), file) == text.size() && std::fflush(file) == 0;
}

struct Closer {
    void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, Closer>;

/// What a signal handler may look at: the name of the file that is being written.
std::atomic<const char*> unfinished = nullptr;

extern "C" void remove_unfinished(int signal) {
    if (const char* name = unfinished.load()) unlink(name);
    std::signal(signal, SIG_DFL); // NOLINT(cert-err33-c): there is nobody to tell
    raise(signal);
}

/// While this lives, the signals that end a run take the file away first.
class Unfinished {
  public:
    explicit Unfinished(const std::string& name) {
        unfinished = name.c_str();
        for (std::size_t i = 0; i < ends.size(); ++i) {
            struct sigaction action {};
            sigaction(ends[i], nullptr, &before_[i]);
            if (before_[i].sa_handler != SIG_DFL) continue; // who ignores a signal still does
            action.sa_handler = &remove_unfinished;
            sigaction(ends[i], &action, nullptr);
        }
    }
    Unfinished(const Unfinished&) = delete;
    Unfinished& operator=(const Unfinished&) = delete;
    ~Unfinished() {
        for (std::size_t i = 0; i < ends.size(); ++i) sigaction(ends[i], &before_[i], nullptr);
        unfinished = nullptr;
    }

  private:
    static constexpr std::array<int, 3> ends{SIGINT, SIGTERM, SIGHUP};
    std::array<struct sigaction, ends.size()> before_{};
};

/// While this lives, a pipe that is closed at the other end is an error like others.
class WithoutPipeSignal {
  public:
    WithoutPipeSignal() { before_ = std::signal(SIGPIPE, SIG_IGN); } // NOLINT(performance-no-int-to-ptr)
    WithoutPipeSignal(const WithoutPipeSignal&) = delete;
    WithoutPipeSignal& operator=(const WithoutPipeSignal&) = delete;
    ~WithoutPipeSignal() { std::signal(SIGPIPE, before_); }

  private:
    void (*before_)(int) = nullptr;
};

/// Opens a pipe or a device; whoever is to read a pipe has some seconds to come.
int open_in_place(const std::string& path) {
    const auto end = std::chrono::steady_clock::now() + patience;
    while (true) {
        const int descriptor = open(path.c_str(), O_WRONLY | O_CLOEXEC | O_NOCTTY | O_NONBLOCK);
        if (descriptor >= 0 || errno != ENXIO || std::chrono::steady_clock::now() >= end) return descriptor;
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
}

std::optional<std::string> write_in_place(const std::string& path, std::string_view text) {
    const WithoutPipeSignal ignored;
    const int descriptor = open_in_place(path);
    if (descriptor < 0 && errno == ENXIO)
        return "nobody has read this pipe for " + std::to_string(patience.count()) +
               " seconds. Start what reads it, or leave it out.";
    if (descriptor < 0) return refusal(errno);
    const File file(fdopen(descriptor, "wb"));
    if (file && fcntl(descriptor, F_SETFL, O_WRONLY) == 0 && write_all(file.get(), text)) return std::nullopt;
    return refusal(errno);
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
std::optional<std::string> replace(const std::string& path, std::string_view text) {
    if (access(path.c_str(), F_OK) == 0 && access(path.c_str(), W_OK) != 0) return refusal(errno);
    std::string temporary = path + ".XXXXXX";
    const mode_t mode = mode_for(path);
    const Unfinished guarded(temporary); // first: mkstemp puts the name into the same bytes
    const int descriptor = mkstemp(temporary.data());
    if (descriptor < 0) return refusal(errno);
    const File file(fdopen(descriptor, "wb"));
    if (file && fchmod(descriptor, mode) == 0 && write_all(file.get(), text) && fsync(descriptor) == 0 &&
        std::rename(temporary.c_str(), path.c_str()) == 0)
        return std::nullopt;
    const int error = errno;
    unlink(temporary.c_str());
    return refusal(error);
}

} // namespace

std::string written_path(const std::string& path) {
    std::error_code none;
    fs::path target = fs::absolute(path, none);
    if (none) return path;
    constexpr int most_links = 40; // as systems have it
    for (int i = 0; i < most_links && fs::is_symlink(target, none); ++i)
        target = target.parent_path() / fs::read_symlink(target, none);
    const fs::path canonical = fs::weakly_canonical(target, none);
    return none ? target.string() : canonical.string();
}

std::optional<std::string> write_file(const std::string& path, std::string_view text) {
    std::error_code none;
    if (fs::exists(path, none) && !fs::is_regular_file(path, none)) return write_in_place(path, text);
    return replace(written_path(path), text); // a report replaces no link
}

std::optional<std::string> write_output(std::string_view text) {
    return write_all(stdout, text) ? std::nullopt : std::optional(refusal(errno));
}

} // namespace maclint::cli
