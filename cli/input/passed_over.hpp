//! What a search of folders passed over, in numbers.
#pragma once

#include <cstddef>
#include <string>

namespace maclint::cli {

/// Files in folders that were searched; what is hidden or excluded is not counted.
struct PassedOver {
    std::size_t other_names = 0;    ///< that no program is known by
    std::size_t ignored_by_git = 0; ///< named like programs
};

/// "10 files with other names passed over, 1 program ignored by git"; empty: none.
[[nodiscard]] std::string text_of(const PassedOver& passed_over);

} // namespace maclint::cli
