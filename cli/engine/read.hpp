//! Finds out what a file is and reads its programs.
#pragma once

#include "cli/engine/program_store.hpp"
#include "cli/engine/snapshot.hpp"

#include <memory>
#include <optional>
#include <string>
#include <variant>

namespace maclint::cli {

/// The bytes of a file, in the encoding that its configuration names.
[[nodiscard]] std::variant<Source, Notice> open_file(const SnapshotFile& file);

/// What came of a file that was looked at.
struct ReadFile {
    std::shared_ptr<const Source> source = {};
    const Dialect* dialect = nullptr; ///< that it was read in; nullptr: not linted, `notice` may say why
    std::string dialect_reason = {};
    const ControlModel* control =
        nullptr;                     ///< that was named, that the text shows, or assumed for the dialect
    std::string control_reason = {}; ///< the marks of it in the text, where these tell
    std::shared_ptr<const ProgramFile> file = {}; ///< nullptr where there is no dialect
    Extent extent = Extent::whole;                ///< of `file`
    std::optional<std::string> not_nc = {}; ///< what it is instead of an NC program (MAC003); `file` has no
                                            ///< programs
    std::optional<Notice> notice = {};
};

/// Finds out what a source is and turns it into programs: to that extent, or whole where only the whole of it
/// tells which language it is in. What is read whole comes from the store.
[[nodiscard]] ReadFile read_source(const SnapshotFile& file, std::shared_ptr<const Source> source,
                                   Extent extent, ProgramStore& store);

} // namespace maclint::cli
