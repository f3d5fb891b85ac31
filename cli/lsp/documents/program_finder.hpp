//! Which programs lie in the folders, and which of them a call means: as the analysis sees them.
#pragma once

#include "analyzer/workspace/resolve.hpp"
#include "cli/engine/outline_store.hpp"
#include "cli/lsp/documents/documents.hpp"
#include "cli/lsp/documents/workspace_files.hpp"

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace maclint::cli::lsp {

/// A program by the places of its file in the snapshot, and of itself in that.
struct ProgramPlace {
    std::size_t file, program;
    friend auto operator<=>(const ProgramPlace&, const ProgramPlace&) = default;
};

/// A call: the n-th of a program, in the order of its effects.
struct CallPlace {
    ProgramPlace caller;
    std::size_t call;
};

/// All programs at one moment.
class ProgramMap {
  public:
    ProgramMap(Snapshot snapshot, std::vector<FileOutline> outlines);
    ProgramMap(const ProgramMap&) = delete;
    ProgramMap& operator=(const ProgramMap&) = delete;

    [[nodiscard]] const Snapshot& snapshot() const { return snapshot_; }
    [[nodiscard]] const std::string& path_of(std::size_t file) const {
        return snapshot_.files[file].input.path;
    }
    [[nodiscard]] std::span<const FileOutline> outlines() const { return outlines_; }
    [[nodiscard]] const ProgramOutline& outline(ProgramPlace place) const {
        return outlines_[place.file].programs[place.program];
    }
    [[nodiscard]] std::optional<std::size_t> file_at(std::string_view path) const;
    /// The programs that a call may mean, the nearest; none: it is computed, or there is no such program.
    [[nodiscard]] std::vector<ProgramPlace> meant_by(const CallPlace& call) const;
    /// All calls that may mean the program.
    [[nodiscard]] std::vector<CallPlace> calls_of(ProgramPlace program) const;

  private:
    [[nodiscard]] bool may_mean(const CallPlace& call, ProgramIndex program) const;

    Snapshot snapshot_;
    std::vector<FileOutline> outlines_;
    std::map<std::string_view, std::size_t> by_path_;
    std::vector<ProgramPlace> places_; ///< by ProgramIndex
    CallResolver resolver_;            ///< last: it refers to the outlines
};

/// Looks at files that have changed since it was asked last. For the thread that reads messages.
class ProgramFinder {
  public:
    ProgramFinder(WorkspaceFiles& files, OutlineStore& seen)
        : files_(files)
        , seen_(seen) {}

    [[nodiscard]] std::shared_ptr<const ProgramMap> map(const std::vector<Document>& documents);

  private:
    struct Looked {
        Source text;
        const Dialect* dialect; ///< that the editor names
        FileOutline outline;
    };
    [[nodiscard]] FileOutline outline_of_text(const SnapshotFile& file);
    [[nodiscard]] FileOutline outline_of_file(const SnapshotFile& file);

    WorkspaceFiles& files_;
    OutlineStore& seen_;
    std::map<std::string, Looked, std::less<>> texts_; ///< of documents, by path
};

} // namespace maclint::cli::lsp
