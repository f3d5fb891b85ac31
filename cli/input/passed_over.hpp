//! What a search of folders passed over, in numbers.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace maclint::cli {

/// Files in folders that were searched; what is hidden or excluded is not counted.
struct PassedOver {
    std::size_t other_names =
        0; ///< that no program is known by; pictures, papers and the like are not counted
    std::size_t ignored_by_git = 0; ///< named like programs
    std::size_t links_out = 0;      ///< that lead out of what was named, to files or folders

    friend PassedOver operator-(const PassedOver& one, const PassedOver& other) {
        return {one.other_names - other.other_names, one.ignored_by_git - other.ignored_by_git,
                one.links_out - other.links_out};
    }
};

/// A file or folder that a search did not take.
struct PassedFile {
    std::string path;
    std::string_view why; ///< "ignored by git"
};

/// "10 files with other names passed over, 1 program ignored by git, 1 link to elsewhere not followed";
/// empty: none.
[[nodiscard]] std::string text_of(const PassedOver& passed_over);

} // namespace maclint::cli
