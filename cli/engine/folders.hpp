//! Folders, compared as texts.
#pragma once

#include <string>

namespace maclint::cli {

/// "shop/" of "shop/O1.nc"; "" of "O1.nc".
[[nodiscard]] inline std::string folder_of(const std::string& path) {
    return path.substr(0, path.rfind('/') + 1);
}

/// The same folder, or one lies in the other.
[[nodiscard]] inline bool lie_together(const std::string& a, const std::string& b) {
    return a.starts_with(b) || b.starts_with(a);
}

} // namespace maclint::cli
