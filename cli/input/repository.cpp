//! Looks for .git.
#include "cli/input/repository.hpp"

#include <system_error>

namespace maclint::cli {

std::optional<std::filesystem::path> repository_around(const std::filesystem::path& folder) {
    std::error_code ignored;
    for (std::filesystem::path at = folder; at.has_relative_path(); at = at.parent_path())
        if (std::filesystem::exists(at / ".git", ignored)) return at;
    return std::nullopt;
}

} // namespace maclint::cli
