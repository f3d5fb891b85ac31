//! Looks for .git.
#include "cli/input/repository.hpp"

#include "analyzer/source/platform/files.hpp"
#include "cli/input/links.hpp"

namespace maclint::cli {

bool is_repository(const std::filesystem::path& folder) {
    const std::filesystem::path git = folder / ".git";
    platform::FileKind kind = platform::kind_unfollowed(git);
    if (kind == platform::FileKind::link && !leaves_drive(git, folder)) kind = platform::kind_of(git);
    return kind == platform::FileKind::folder || kind == platform::FileKind::regular;
}

std::optional<std::filesystem::path> repository_around(const std::filesystem::path& folder) {
    for (std::filesystem::path at = folder; at.has_relative_path(); at = at.parent_path())
        if (is_repository(at)) return at;
    return std::nullopt;
}

} // namespace maclint::cli
