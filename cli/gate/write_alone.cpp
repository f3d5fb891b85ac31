//! With a lock beside the file.
#include "cli/gate/write_alone.hpp"

#include "analyzer/source/platform/files.hpp"
#include "analyzer/source/platform/lock.hpp"
#include "analyzer/source/platform/output.hpp"
#include "analyzer/source/platform/paths.hpp"
#include "cli/text/shown.hpp"

#include <cerrno>
#include <optional>
#include <system_error>
#include <utility>

namespace maclint::cli {
namespace {

/// What is said where the lock cannot be had.
std::optional<Notice> refusal(const platform::WriteLock& lock, const std::string& path) {
    const std::string name = shown(platform::lock_name(path));
    const auto refuse = [&](const std::string& why) {
        return Notice{NoticeKind::unreadable, path, "cannot be written: " + why};
    };
    switch (lock.error()) {
    case 0: return std::nullopt;
    case EBUSY:
        return refuse("for " + std::to_string(platform::patience_with_writers.count()) +
                      " seconds other runs of maclint have been writing it. Start this one again when they "
                      "have ended.");
    case EEXIST: return refuse("'" + name + "' beside it is no lock of maclint. Remove or rename it.");
    case ENOLCK:
    case ENOTSUP:
        return refuse("its folder knows no locks, so that other runs may write at the same time. Keep the "
                      "baseline on a local disk.");
    default:
        return refuse("the system says '" + std::generic_category().message(lock.error()) + "' of '" + name +
                      "' beside it. Check the folder, its permissions and the space that is left.");
    }
}

/// Pipes and devices are written as they are.
bool is_replaced(const std::string& path) {
    switch (platform::kind_of(platform::path_of(path))) {
    case platform::FileKind::missing:
    case platform::FileKind::broken_link:
    case platform::FileKind::regular: return true;
    default: return false;
    }
}

} // namespace

Notice write_alone(const std::string& path, const std::function<Notice()>& write) {
    if (!is_replaced(path)) return write();
    const platform::WriteLock lock(platform::written_path(path)); // its other names have the same
    if (auto refused = refusal(lock, path)) return *std::move(refused);
    return write();
}

} // namespace maclint::cli
