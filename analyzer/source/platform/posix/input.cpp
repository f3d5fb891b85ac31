//! open, fstat, read, and poll, each again after a signal; what may not come back is done on a thread that
//! can be given up.
#include "analyzer/source/platform/input.hpp"

#include "analyzer/source/platform/threads.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <future>
#include <memory>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#if __has_include(<sys/vfs.h>)
#include <sys/sysmacros.h>
#include <sys/vfs.h>
#endif
#include <unistd.h>

namespace maclint::platform {
namespace {

namespace chrono = std::chrono;
using Clock = chrono::steady_clock;

FileKind kind_for(mode_t mode) {
    if (S_ISREG(mode)) return FileKind::regular;
    if (S_ISDIR(mode)) return FileKind::folder;
    return S_ISFIFO(mode) ? FileKind::pipe : FileKind::other;
}

/// Time that is left, at least none.
chrono::milliseconds until(Clock::time_point end) {
    return std::max(chrono::ceil<chrono::milliseconds>(end - Clock::now()), chrono::milliseconds(0));
}

/// What `work` gives; nothing when it does not come back in time. Its thread then waits alone, for as long as
/// the process lives, so it must own all that it touches. Without memory for a thread the work is waited for.
template<class Work>
auto given_up_after(chrono::milliseconds patience, Work work) -> std::optional<decltype(work())> {
    if (!has_memory_for_thread()) return work();
    const auto task = std::make_shared<std::packaged_task<decltype(work())()>>(std::move(work));
    auto result = task->get_future();
    try {
        std::thread([task] { (*task)(); }).detach();
    } catch (const std::system_error&) {
        (*task)(); // no thread is to be had
    }
    if (result.wait_for(patience) != std::future_status::ready) return std::nullopt;
    return result.get();
}

/// A copy of an open file, so that nobody else's close can give its number to another one.
class Duplicate {
  public:
    explicit Duplicate(int descriptor)
        : descriptor_(::fcntl(descriptor, F_DUPFD_CLOEXEC, 0)) {}
    Duplicate(const Duplicate&) = delete;
    Duplicate& operator=(const Duplicate&) = delete;
    ~Duplicate() {
        if (descriptor_ >= 0) ::close(descriptor_);
    }
    [[nodiscard]] int get() const { return descriptor_; }

  private:
    int descriptor_;
};

#if __has_include(<sys/vfs.h>)
/// File systems of a disk or of memory, as statfs(2) numbers them. Others are of a network, of a program
/// (FUSE), or views of the kernel (/proc, /sys): a read there may wait for whatever it likes.
constexpr auto local_file_systems = std::to_array<unsigned long>({
    0xEF53,     // ext2, ext3, ext4
    0x58465342, // xfs
    0x9123683E, // btrfs
    0xCA451A4E, // bcachefs
    0xF2F52010, // f2fs
    0x2FC12FC1, // zfs
    0x3153464A, // jfs
    0x52654973, // reiserfs
    0x01021994, // tmpfs
    0x858458F6, // ramfs
    0x794C7630, // overlayfs
    0x73717368, // squashfs
    0xE0F5E1E2, // erofs
    0x9660,     // iso9660
    0x15013346, // udf
    0x4D44,     // vfat
    0x2011BAB0, // exfat
    0x5346544E, // ntfs
    0x7366746E, // ntfs3
    0x4244,     // hfs
    0x482B,     // hfs+
});

/// Whether the number of a file system is that of a disk; others have one that is made up (major 0).
bool is_block_device(dev_t device) { return major(device) != 0; }

bool is_of_a_disk(int descriptor) {
    struct statfs status = {};
    if (::fstatfs(descriptor, &status) != 0) return false;
    const unsigned long type = static_cast<unsigned long>(status.f_type) & 0xFFFFFFFFUL;
    return std::ranges::find(local_file_systems, type) != local_file_systems.end();
}
#else
bool is_block_device(dev_t /*device*/) { return false; }
bool is_of_a_disk(int /*descriptor*/) { return false; }
#endif

/// The same, asked once a file system and thread; one whose program does not answer is none of a disk.
bool is_of_a_disk(int descriptor, dev_t device, chrono::milliseconds patience) {
    if (is_block_device(device)) return true;
    static constinit thread_local dev_t last_device = 0;
    static constinit thread_local bool last_answer = false;
    if (last_device != device || device == 0) {
        const auto copy = std::make_shared<const Duplicate>(descriptor);
        last_answer = given_up_after(patience, [copy] { return is_of_a_disk(copy->get()); }).value_or(false);
        last_device = device;
    }
    return last_answer;
}

Portion read_once(int descriptor, std::span<char> bytes) {
    while (true) {
        const ssize_t count = ::read(descriptor, bytes.data(), bytes.size());
        if (count >= 0) return {static_cast<std::size_t>(count), 0};
        if (errno != EINTR) return {0, errno == EWOULDBLOCK ? EAGAIN : errno};
    }
}

/// The same of a file whose system may not answer.
std::optional<Portion> read_elsewhere(int descriptor, std::span<char> bytes, chrono::milliseconds patience) {
    constexpr std::size_t most = std::size_t{1} << 20U;
    const auto copy = std::make_shared<const Duplicate>(descriptor);
    const auto buffer = std::make_shared<std::vector<char>>(std::min(bytes.size(), most));
    const auto portion = given_up_after(patience, [copy, buffer] { return read_once(copy->get(), *buffer); });
    if (portion) std::copy_n(buffer->begin(), portion->count, bytes.begin());
    return portion;
}

constexpr chrono::seconds patience_with_file_systems{10};

} // namespace

OpenFile::OpenFile(const std::string& path)
    // O_NONBLOCK stays: without it a named pipe that nobody has opened for writing would hang here, and
    // /proc/kmsg, a file by its mode, when it is read.
    : descriptor_(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOCTTY | O_NONBLOCK)) {
    struct stat status = {};
    if (descriptor_ < 0 || ::fstat(descriptor_, &status) != 0) {
        error_ = errno;
        return;
    }
    kind_ = kind_for(status.st_mode);
    size_ = static_cast<std::uintmax_t>(status.st_size);
    never_waits_ =
        kind_ == FileKind::regular && is_of_a_disk(descriptor_, status.st_dev, patience_with_file_systems);
}

OpenFile::OpenFile(StandardInput /*which*/)
    : descriptor_(STDIN_FILENO) {
    struct stat status = {};
    if (::fstat(descriptor_, &status) != 0) return; // reading says what is wrong
    kind_ = kind_for(status.st_mode);
    const off_t begin = ::lseek(descriptor_, 0, SEEK_CUR); // others may have read a part of it
    if (begin >= 0 && begin < status.st_size) size_ = static_cast<std::uintmax_t>(status.st_size - begin);
    never_waits_ =
        kind_ == FileKind::regular && is_of_a_disk(descriptor_, status.st_dev, patience_with_file_systems);
}

OpenFile::~OpenFile() {
    if (descriptor_ >= 0 && descriptor_ != STDIN_FILENO) ::close(descriptor_);
}

std::optional<Portion> OpenFile::read_some(std::span<char> bytes, chrono::milliseconds patience) {
    const bool may_hang = kind_ == FileKind::regular && !never_waits_;
    auto end = Clock::now() + patience;
    if (kind_ == FileKind::regular)
        end -= waited_;
    else if (!comes_in_time(descriptor_, patience)) // a pipe without a writer has no end yet
        return std::nullopt;
    while (true) {
        const auto portion = may_hang ? read_elsewhere(descriptor_, bytes, until(end))
                                      : std::optional(read_once(descriptor_, bytes));
        if (!portion || portion->error != EAGAIN) return portion;
        const auto begun = Clock::now();
        const bool came = comes_in_time(descriptor_, until(end));
        if (!came || begun >= end) return std::nullopt;
        // Some files are ready all the time and give nothing.
        std::this_thread::sleep_for(chrono::milliseconds(10));
        waited_ += chrono::ceil<chrono::milliseconds>(Clock::now() - begun);
    }
}

bool comes_in_time(int descriptor, chrono::milliseconds patience) {
    if (isatty(descriptor) != 0) return true;
    const auto end = Clock::now() + patience;
    while (true) {
        pollfd file{.fd = descriptor, .events = POLLIN, .revents = 0};
        const int ready = poll(&file, 1, static_cast<int>(until(end).count()));
        if (ready >= 0 || errno != EINTR) return ready != 0;
    }
}

} // namespace maclint::platform
