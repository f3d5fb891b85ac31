//! Looks for .git.
#include "cli/input/repository.hpp"

#include "analyzer/source/platform/files.hpp"

namespace maclint::cli {
namespace {

bool is_there(const std::filesystem::path& path) {
    const platform::FileKind kind = platform::kind_of(path);
    return kind != platform::FileKind::missing && kind != platform::FileKind::broken_link;
}

} // namespace

std::optional<std::filesystem::path> repository_around(const std::filesystem::path& folder) {
    for (std::filesystem::path at = folder; at.has_relative_path(); at = at.parent_path())
        if (is_there(at / ".git")) return at;
    return std::nullopt;
}

} // namespace maclint::cli
