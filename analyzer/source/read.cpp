//! Reading files: the only place that talks to the operating system about a program's bytes.
#include "analyzer/source/pipe_wait.hpp"
#include "analyzer/source/source.hpp"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <limits>
#include <optional>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace maclint {
namespace {

/// One byte less than an Offset can hold, so that lines and columns, which count from 1, fit as well.
constexpr std::size_t largest_file = std::numeric_limits<Offset>::max() - 1;
constexpr std::size_t growth_step = std::size_t{64} * 1024;

/// An open file that closes itself.
class Descriptor {
  public:
    explicit Descriptor(int number)
        : number_(number) {}
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    ~Descriptor() {
        if (number_ >= 0) ::close(number_);
    }
    [[nodiscard]] int number() const { return number_; }

  private:
    int number_;
};

std::string quoted(const std::string& path) {
    return "'" + printable(to_utf8(path, detect_encoding(path))) + "'";
}

InputError cannot_read(const std::string& path, const std::string& why) {
    return {path, quoted(path) + " cannot be read: " + why};
}

InputError system_refused(const std::string& path, int error) {
    switch (error) {
    case ENOENT:
    case ENOTDIR: return cannot_read(path, "there is no such file. Check the spelling and the folder.");
    case EACCES:
    case EPERM:
        return cannot_read(path,
                           "you have no permission. Ask its owner for read access or leave the file out.");
    case ELOOP:
        return cannot_read(path, "its symbolic links lead in a circle. Mend the link or leave it out.");
    case ENAMETOOLONG: return cannot_read(path, "the path is too long for the system. Shorten it.");
    case EMFILE:
    case ENFILE:
        return cannot_read(path, "too many files are open. Raise the limit (ulimit -n) or lower --jobs.");
    case EIO:
        return cannot_read(path, "the disk or the network reports an error. Copy the file and try again.");
    default: return cannot_read(path, "the system says '" + std::generic_category().message(error) + "'.");
    }
}

InputError too_large(const std::string& path) {
    return cannot_read(path, "it has 4 GiB or more. Split the program or leave the file out.");
}

std::optional<InputError> refuse_kind(const std::string& path, const struct stat& status) {
    if (S_ISDIR(status.st_mode)) return cannot_read(path, "it is a folder. Name the files in it instead.");
    if (S_ISREG(status.st_mode) || S_ISFIFO(status.st_mode)) return std::nullopt;
    return cannot_read(path, "it is a device or a socket. Name a file instead.");
}

InputError silent(const std::string& path, std::chrono::seconds patience) {
    return cannot_read(path, "nothing has come through this pipe for " + std::to_string(patience.count()) +
                                 " seconds. Start what writes to it, or leave it out.");
}

/// Reads to the end. The file may grow or shrink meanwhile: its size is only a hint.
std::variant<std::string, InputError> read_all(int descriptor, const std::string& path, std::size_t size_hint,
                                               std::chrono::seconds patience) {
    if (size_hint > largest_file) return too_large(path);
    std::string bytes(size_hint + 1, '\0');
    std::size_t filled = 0;
    while (true) {
        if (filled == bytes.size()) bytes.resize(std::max(bytes.size() + bytes.size() / 2, growth_step));
        if (!comes_in_time(descriptor, patience)) return silent(path, patience);
        const ssize_t count = ::read(descriptor, bytes.data() + filled, bytes.size() - filled);
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) return system_refused(path, errno);
        if (count == 0) break;
        filled += static_cast<std::size_t>(count);
        if (filled > largest_file) return too_large(path);
    }
    bytes.resize(filled);
    return bytes;
}

std::variant<Source, InputError> to_source(std::string path, std::variant<std::string, InputError> result) {
    if (auto* const error = std::get_if<InputError>(&result)) return std::move(*error);
    return Source::from_bytes(std::move(path), std::get<std::string>(std::move(result)));
}

} // namespace

std::variant<Source, InputError> Source::read_file(std::string path) {
    // Without O_NONBLOCK a named pipe that nobody has opened for writing would hang here.
    const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOCTTY | O_NONBLOCK));
    if (file.number() < 0) return system_refused(path, errno);
    struct stat status = {};
    if (::fstat(file.number(), &status) != 0) return system_refused(path, errno);
    if (auto refused = refuse_kind(path, status)) return *std::move(refused);
    if (::fcntl(file.number(), F_SETFL, O_RDONLY) != 0) return system_refused(path, errno);
    auto bytes = read_all(file.number(), path, static_cast<std::size_t>(status.st_size), patience_with_pipes);
    return to_source(std::move(path), std::move(bytes));
}

std::variant<Source, InputError> Source::read_standard_input(std::string path) {
    auto bytes = read_all(STDIN_FILENO, path, 0, patience_with_input);
    return to_source(std::move(path), std::move(bytes));
}

} // namespace maclint
