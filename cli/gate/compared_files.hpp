//! Files of one repository against what they were at a revision.
#pragma once

#include "analyzer/source/source.hpp"
#include "cli/gate/line_difference.hpp"
#include "cli/gate/repository_history.hpp"
#include "cli/notice.hpp"

#include <cstdint>
#include <string>
#include <unordered_map>
#include <vector>

namespace maclint::cli {

struct FileToCompare {
    enum class Wanted : std::uint8_t {
        lines,   ///< which of its lines have changed
        nothing, ///< it only takes part where it is told which gone file a new one was
    };
    const Source* source;
    std::string path; ///< from the root, with '/'
    Wanted wanted;
};

struct ComparedFiles {
    /// Of a file that is not in here all lines have changed.
    std::unordered_map<const Source*, std::vector<LineRange>> ranges = {};
    std::vector<Notice> notices = {}; ///< what went wrong, and what is worth telling
};

/// The revision is named as the user did.
[[nodiscard]] ComparedFiles compare_files(const RepositoryHistory& history, const std::string& revision,
                                          const std::vector<FileToCompare>& files);

} // namespace maclint::cli
