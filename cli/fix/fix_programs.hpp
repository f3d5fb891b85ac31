//! Fixes programs until nothing is left to fix, in memory.
#pragma once

#include "cli/engine/engine.hpp"
#include "cli/fix/choose.hpp"

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace maclint::cli {

struct FixedFile {
    std::string path;
    std::shared_ptr<const Source> before; ///< as it was read
    std::string after;                    ///< its bytes, as they are to be stored
    std::size_t findings;                 ///< that are mended
};

struct FixedPrograms {
    Result result; ///< what is left
    std::vector<FixedFile> files;
    std::vector<Notice> notices; ///< on files that are left as they were
};

/// Analyses the snapshot, and judges what is found.
using Analyse = std::function<Result(const Snapshot&)>;

/// Applies the fixes that are wanted, round by round. A file whose fixes undo one another, or cannot be
/// written in its encoding, stays as it was.
[[nodiscard]] FixedPrograms fix_programs(const Snapshot& snapshot, FixesWanted wanted,
                                         const Analyse& analyse);

} // namespace maclint::cli
