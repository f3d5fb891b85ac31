//! Programs of texts, for what is asked of a place in them.
#pragma once

#include "cli/engine/read.hpp"
#include "cli/lsp/documents/documents.hpp"
#include "cli/lsp/documents/workspace_files.hpp"
#include "cli/renumber/block_numbers.hpp"

#include <map>
#include <memory>
#include <string>

namespace maclint::cli::lsp {

/// A text that was read as its configuration says: whole, where nothing else is asked for.
struct ReadText {
    std::string uri;
    SnapshotFile file;
    ReadFile read; ///< `read.file` is there
    LineTable lines;
    mutable std::shared_ptr<const NumberSpaces> spaces = {}; ///< of its blocks; nullptr: nobody has asked

    [[nodiscard]] const ProgramFile& programs() const { return *read.file; }
    [[nodiscard]] const Source& source() const { return lines.source(); }
    [[nodiscard]] const Dialect& dialect() const { return *read.dialect; }
};

/// Keeps what it has read of documents until they change.
class TextReader {
  public:
    explicit TextReader(WorkspaceFiles& files)
        : files_(files) {}

    /// nullptr: it is no program.
    [[nodiscard]] std::shared_ptr<const ReadText> read(const Document& document, PositionEncoding encoding);
    /// Of a file that is not open, to that extent; nullptr: it is none, or cannot be read.
    [[nodiscard]] std::shared_ptr<const ReadText> read_file(const std::string& path,
                                                            PositionEncoding encoding, Extent extent);
    /// Of documents that are closed, or whose configuration may have changed.
    void forget();

  private:
    struct Kept {
        Document document;
        std::shared_ptr<const ReadText> text;
    };
    [[nodiscard]] std::shared_ptr<const ReadText> read(const std::string& uri, SnapshotFile file,
                                                       PositionEncoding encoding, Extent extent);

    WorkspaceFiles& files_;
    ProgramStore store_{std::size_t{64} << 20U};
    std::map<std::string, Kept> by_uri_;
};

} // namespace maclint::cli::lsp
