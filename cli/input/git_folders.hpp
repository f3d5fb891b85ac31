//! Where git keeps what it knows of a repository.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace maclint::cli {

struct GitFolders {
    std::filesystem::path own;    ///< of this working tree
    std::filesystem::path common; ///< of all working trees of the repository; mostly the same
};

/// Of the folder that holds the .git, as that and `commondir` say (gitrepository-layout(5)). What leads to
/// another drive or server is not gone after. Where a .git is not as it should be, git itself will say so.
[[nodiscard]] GitFolders git_folders_of(const std::filesystem::path& root);

/// The path that the text of a .git, behind "gitdir: ", or of `commondir` names, as git reads it: all of the
/// text but line ends behind it. Empty: none.
[[nodiscard]] std::string path_named_in(std::string_view text, std::string_view word);

/// Whether only a part of the revision's files was written to the working tree: what is not there is not
/// gone.
[[nodiscard]] bool is_sparse(const std::filesystem::path& root);

} // namespace maclint::cli
