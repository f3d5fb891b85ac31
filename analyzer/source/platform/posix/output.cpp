//! A new file is written beside the old one and takes its name; a signal in between takes it away.
#include "analyzer/source/platform/output.hpp"

#include "analyzer/source/platform/files.hpp"
#include "analyzer/source/platform/posix/signals.hpp"

#include <array>
#include <atomic>
#include <cerrno>
#include <charconv>
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

namespace maclint::platform {
namespace {

namespace fs = std::filesystem;

bool write_all(std::FILE* file, std::string_view text) {
    return std::fwrite(text.data(), 1, text.size(), file) == text.size() && std::fflush(file) == 0;
}

struct Closer {
    void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, Closer>;

/// What a signal handler may look at: the name of the file that is being written.
std::atomic<const char*> unfinished = nullptr;

extern "C" void end_by_signal(int signal) {
    remove_unfinished();
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
            action.sa_handler = &end_by_signal;
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
    static constexpr std::array<int, 5> ends{SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGXCPU};
    std::array<struct sigaction, ends.size()> before_{};
};

/// Of what the path names by its number: -1, it names nothing so.
int open_descriptor(const std::string& path) {
    std::error_code error;
    const fs::path numbers = fs::canonical("/dev/fd", error); // on Linux in the folder of this process
    fs::path at = fs::absolute(path, error);
    constexpr int most_links = 40; // as systems have it
    for (int i = 0; i < most_links && !error; ++i) {
        const std::string name = at.filename().string();
        const fs::path folder = fs::canonical(at.parent_path(), error);
        if (error) break;
        int number = -1;
        const auto [end, wrong] = std::from_chars(name.data(), name.data() + name.size(), number);
        if (folder == numbers && wrong == std::errc() && end == name.data() + name.size()) return number;
        if (!fs::is_symlink(at, error)) break;
        at = folder / fs::read_symlink(at, error);
    }
    return -1;
}

int write_to_open(int open, std::string_view text) {
    const int descriptor = fcntl(open, F_DUPFD_CLOEXEC, 0);
    if (descriptor < 0) return errno;
    const File file(fdopen(descriptor, "ab"));
    return file && write_all(file.get(), text) ? 0 : errno;
}

/// Opens a pipe or a device; whoever is to read a pipe has some seconds to come.
int open_in_place(const std::string& path) {
    const auto end = std::chrono::steady_clock::now() + patience_with_readers;
    while (true) {
        const int descriptor = open(path.c_str(), O_WRONLY | O_CLOEXEC | O_NOCTTY | O_NONBLOCK);
        if (descriptor >= 0 || errno != ENXIO || std::chrono::steady_clock::now() >= end) return descriptor;
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
}

/// The rights that fopen would give a new file, or those of the file that is replaced.
mode_t mode_for(const std::string& path) {
    struct stat old {};
    if (stat(path.c_str(), &old) == 0) return old.st_mode & 07777U;
    const mode_t mask = umask(0);
    umask(mask);
    return 0666U & ~mask;
}

} // namespace

fs::path place_of(const fs::path& path) {
    std::error_code none;
    if (fs::path real = real_path(path, none); !none) return real;
    fs::path target = fs::absolute(path, none);
    if (none) return path;
    constexpr int most_links = 40; // as systems have it
    for (int i = 0; i < most_links && fs::is_symlink(target, none); ++i)
        target = target.parent_path() / fs::read_symlink(target, none);
    fs::path canonical = fs::weakly_canonical(target, none);
    return none ? target : canonical;
}

std::string written_path(const std::string& path) { return place_of(path).string(); }

int replace_file(const std::string& path, std::string_view text) {
    if (access(path.c_str(), F_OK) == 0 && access(path.c_str(), W_OK) != 0) return errno;
    const WithoutSignal ignored(SIGXFSZ);
    std::string temporary = path + ".XXXXXX";
    const mode_t mode = mode_for(path);
    const Unfinished guarded(temporary); // first: mkstemp puts the name into the same bytes
    const int descriptor = mkstemp(temporary.data());
    if (descriptor < 0) return errno;
    const File file(fdopen(descriptor, "wb"));
    if (file && fchmod(descriptor, mode) == 0 && write_all(file.get(), text) && fsync(descriptor) == 0 &&
        std::rename(temporary.c_str(), path.c_str()) == 0)
        return 0;
    const int error = errno;
    unlink(temporary.c_str());
    return error;
}

void remove_unfinished() noexcept {
    if (const char* name = unfinished.load()) unlink(name);
}

int write_in_place(const std::string& path, std::string_view text) {
    const WithoutSignal ignored(SIGPIPE);
    if (const int open = open_descriptor(path); open >= 0) return write_to_open(open, text);
    const int descriptor = open_in_place(path);
    if (descriptor < 0) return errno;
    const File file(fdopen(descriptor, "wb"));
    if (file && fcntl(descriptor, F_SETFL, O_WRONLY) == 0 && write_all(file.get(), text)) return 0;
    return errno;
}

bool names_open_file(const std::string& path) { return open_descriptor(path) >= 0; }

bool names_standard_output(const std::string& path) {
    return path == "/dev/stdout" || path == "/dev/fd/1" || path == "/proc/self/fd/1";
}

bool is_standard_output(const std::string& path) {
    struct stat output {};
    struct stat file {};
    return fstat(STDOUT_FILENO, &output) == 0 && stat(path.c_str(), &file) == 0 && !S_ISCHR(file.st_mode) &&
           output.st_dev == file.st_dev && output.st_ino == file.st_ino;
}

} // namespace maclint::platform
