//! open, fstat, read, and poll, each again after a signal.
#include "analyzer/source/platform/input.hpp"

#include <algorithm>
#include <cerrno>

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

namespace maclint::platform {
namespace {

FileKind kind_for(mode_t mode) {
    if (S_ISREG(mode)) return FileKind::regular;
    if (S_ISDIR(mode)) return FileKind::folder;
    return S_ISFIFO(mode) ? FileKind::pipe : FileKind::other;
}

} // namespace

OpenFile::OpenFile(const std::string& path)
    // Without O_NONBLOCK a named pipe that nobody has opened for writing would hang here.
    : descriptor_(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOCTTY | O_NONBLOCK)) {
    struct stat status = {};
    if (descriptor_ < 0 || ::fstat(descriptor_, &status) != 0 || ::fcntl(descriptor_, F_SETFL, O_RDONLY) != 0)
        error_ = errno;
    kind_ = kind_for(status.st_mode);
    size_ = static_cast<std::uintmax_t>(status.st_size);
}

OpenFile::~OpenFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
}

Portion read_some(int descriptor, std::span<char> bytes) {
    while (true) {
        const ssize_t count = ::read(descriptor, bytes.data(), bytes.size());
        if (count >= 0) return {static_cast<std::size_t>(count), 0};
        if (errno != EINTR) return {0, errno};
    }
}

bool comes_in_time(int descriptor, std::chrono::milliseconds patience) {
    if (isatty(descriptor) != 0) return true;
    const auto end = std::chrono::steady_clock::now() + patience;
    while (true) {
        const auto left =
            std::chrono::ceil<std::chrono::milliseconds>(end - std::chrono::steady_clock::now());
        pollfd file{.fd = descriptor, .events = POLLIN, .revents = 0};
        const int ready = poll(&file, 1, static_cast<int>(std::max<std::int64_t>(left.count(), 0)));
        if (ready >= 0 || errno != EINTR) return ready != 0;
    }
}

} // namespace maclint::platform
