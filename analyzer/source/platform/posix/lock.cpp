//! flock on a file of its own, as the one that is written gets replaced.
#include "analyzer/source/platform/lock.hpp"

#include <cerrno>
#include <optional>
#include <string>
#include <thread>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace maclint::platform {
namespace {

/// Another user's, or one in a folder such as /tmp, cannot be opened for writing, but be locked all the same.
int open_lock(const std::string& name) {
    constexpr int common = O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK;
    constexpr mode_t mode = 0666;
    const int descriptor = open(name.c_str(), O_RDWR | O_CREAT | common, mode);
    if (descriptor >= 0 || errno != EACCES) return descriptor;
    const int readable = open(name.c_str(), O_RDONLY | common);
    if (readable < 0 && errno == ENOENT) errno = EACCES; // there is none, and none can be made
    return readable;
}

/// Whoever held it before may have removed its name in between.
bool is_still_named(const struct stat& opened, const std::string& name) {
    struct stat named {};
    return lstat(name.c_str(), &named) == 0 && named.st_dev == opened.st_dev && named.st_ino == opened.st_ino;
}

/// Nothing: once more, at once.
std::optional<int> error_of_lock(int descriptor, const std::string& name) {
    struct stat opened {};
    if (fstat(descriptor, &opened) != 0) return errno;
    if (!S_ISREG(opened.st_mode) || opened.st_size != 0) return EEXIST;
    if (flock(descriptor, LOCK_EX | LOCK_NB) != 0) return errno == EWOULDBLOCK ? EBUSY : errno;
    return is_still_named(opened, name) ? std::optional(0) : std::nullopt;
}

} // namespace

struct WriteLock::Held {
    std::string name;
    int descriptor;
};

std::string lock_name(const std::string& path) { return path + ".lock"; }

WriteLock::WriteLock(const std::string& path) {
    const std::string name = lock_name(path);
    const auto end = std::chrono::steady_clock::now() + patience_with_writers;
    while (true) {
        const int descriptor = open_lock(name);
        if (descriptor < 0) {
            error_ = errno == ELOOP ? EEXIST : errno; // a link
            return;
        }
        const std::optional<int> error = error_of_lock(descriptor, name);
        if (error == 0) {
            held_ = std::make_unique<Held>(Held{name, descriptor});
            return;
        }
        close(descriptor);
        if (!error) continue;
        if (error != EBUSY || std::chrono::steady_clock::now() >= end) {
            error_ = *error;
            return;
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
}

WriteLock::~WriteLock() {
    if (!held_) return;
    unlink(held_->name.c_str()); // while it is held: nobody else holds another one of that name
    close(held_->descriptor);
}

} // namespace maclint::platform
