//! Where git keeps what it knows of a repository.
#pragma once

#include <filesystem>

namespace maclint::cli {

struct GitFolders {
    std::filesystem::path own;    ///< of this working tree
    std::filesystem::path common; ///< of all working trees of the repository; mostly the same
};

/// Of the folder that holds the .git, as that and `commondir` say (gitrepository-layout(5)). What leads to
/// another drive or server is not gone after. Where a .git is not as it should be, git itself will say so.
[[nodiscard]] GitFolders git_folders_of(const std::filesystem::path& root);

} // namespace maclint::cli
