//! What lies in a repository's .git, as far as it decides where git looks, read without following it.
#pragma once

#include "cli/notice.hpp"

#include <filesystem>
#include <optional>
#include <string>

namespace maclint::cli {

/// Where git keeps what it knows of a working tree.
struct GitFolders {
    std::filesystem::path own;    ///< of this working tree
    std::filesystem::path common; ///< of all working trees of the repository; mostly the same
};

/// Of the folder that holds the .git. Where that is not as it should be, git itself will say so.
[[nodiscard]] GitFolders git_folders_of(const std::string& root);

/// A pipe or a device in the place of a file that git reads would stop it for ever.
[[nodiscard]] std::optional<Notice> refuse_special_files(const std::string& root);

/// Windows opens the share of any server that a .git names; only the one that holds the repository may be.
[[nodiscard]] std::optional<Notice> refuse_other_servers(const std::string& root);

/// Whether only a part of the revision's files was written to the working tree: what is not there is not
/// gone.
[[nodiscard]] bool is_sparse(const std::string& root);

} // namespace maclint::cli
