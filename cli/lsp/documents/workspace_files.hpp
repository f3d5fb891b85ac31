//! The programs of the editor's folders, and those around files that it has opened elsewhere.
#pragma once

#include "cli/config/settings.hpp"
#include "cli/engine/snapshot.hpp"
#include "cli/lsp/documents/documents.hpp"

#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

namespace maclint::cli::lsp {

/// Of which files findings are wanted.
enum class Asked : std::uint8_t {
    documents, ///< what the editor holds
    all,       ///< that, and all programs of the folders
};

/// Remembers what lies in the folders until somebody says that it has changed. May be asked on several
/// threads.
class WorkspaceFiles {
  public:
    void set_folders(std::vector<std::string> folders);
    [[nodiscard]] std::vector<std::string> folders() const;
    /// What lies on the disk has changed, or a configuration has.
    void forget();
    /// All files, with the texts of the documents in place of those on the disk.
    [[nodiscard]] Snapshot snapshot(const std::vector<Document>& documents, Asked asked);
    /// One file with what its configuration says of it; nothing where that is wrong.
    [[nodiscard]] std::optional<SnapshotFile> file(const Document& document);
    [[nodiscard]] std::optional<SnapshotFile> file(const std::string& path);
    /// Whether the path lies in one of the folders.
    [[nodiscard]] bool has(std::string_view path) const;
    /// What was met since the last call: configurations that are wrong, folders that cannot be read.
    [[nodiscard]] std::vector<Notice> take_notices();

  private:
    struct Known {
        explicit Known(const std::vector<std::string>& folders);
        Settings settings;
        Settings isolated; ///< of texts that are no files
        std::vector<SnapshotFile> files;
        std::map<std::string, std::size_t, std::less<>> by_path;
        std::map<std::string, std::vector<SnapshotFile>, std::less<>> around; ///< files elsewhere, by path
        std::vector<Notice> notices;
    };
    [[nodiscard]] std::shared_ptr<Known> known();
    [[nodiscard]] static std::optional<SnapshotFile> in(Known& known, const std::string& path, bool is_file);
    static const std::vector<SnapshotFile>& around(Known& known, const std::string& path);
    void add_elsewhere(Known& known, const std::vector<Document>& documents, Snapshot& snapshot) const;

    mutable std::mutex mutex_;
    std::vector<std::string> folders_;
    std::shared_ptr<Known> known_;
    std::shared_ptr<Known> before_; ///< controls of the last snapshot may be made for it
};

} // namespace maclint::cli::lsp
