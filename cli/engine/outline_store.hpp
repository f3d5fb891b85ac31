//! Files at which a look need not be taken again while they stay as they are.
#pragma once

#include "analyzer/source/platform/files.hpp"
#include "analyzer/workspace/outline.hpp"
#include "cli/engine/read.hpp"
#include "cli/engine/snapshot.hpp"

#include <map>
#include <mutex>
#include <optional>
#include <string>

namespace maclint::cli {

/// A file after the first look at it.
struct SeenFile {
    ReadFile read; ///< `file` only where it was read whole and kept
    FileOutline outline;
};

/// What a look at files on the disk has shown, by path, stamp and settings. May be asked on several threads.
class OutlineStore {
  public:
    /// Of the file as it is now; nothing where it has to be looked at.
    [[nodiscard]] std::optional<SeenFile> find(const SnapshotFile& file,
                                               const std::optional<platform::FileStamp>& stamp);
    /// `stamp` was taken before the file was read; nothing is kept without one. The text is not kept.
    void keep(const SnapshotFile& file, const std::optional<platform::FileStamp>& stamp, SeenFile seen);
    /// Lets go what was not asked for since the last call.
    void drop_unused();

  private:
    struct Kept {
        platform::FileStamp stamp;
        FileSettings settings; ///< which own the control
        bool named;
        SeenFile seen;
        bool used = true;
    };

    std::mutex mutex_;
    std::map<std::string, Kept, std::less<>> by_path_;
};

} // namespace maclint::cli
