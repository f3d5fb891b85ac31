//! Reads files and turns them into programs, many at a time.
#pragma once

#include "cli/config/settings.hpp"
#include "cli/input/discover.hpp"
#include "cli/progress.hpp"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace maclint::cli {

/// A file that was looked at, and what came of it.
struct ReadFile {
    InputFile input;
    FileSettings settings;
    const Dialect* dialect = nullptr; ///< that it was read in
    std::string dialect_reason;
    std::shared_ptr<const ProgramFile> file; ///< nullptr: not linted, `notice` may say why
    std::optional<std::string>
        not_nc; ///< what it is instead of an NC program (MAC003); `file` has no programs
    std::optional<Notice> notice;
};

/// Finds out what a source is and turns it into programs.
[[nodiscard]] ReadFile read_source(InputFile input, FileSettings settings, Source bytes);

/// In the order of `inputs`. Files whose configuration is wrong are left out; `settings` has the notices.
[[nodiscard]] std::vector<ReadFile> read_files(std::vector<InputFile> inputs, Settings& settings,
                                               unsigned jobs, Progress& progress);

} // namespace maclint::cli
