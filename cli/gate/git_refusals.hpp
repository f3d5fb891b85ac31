//! Repositories that git is not asked about, because of where it would look; they are read without following.
#pragma once

#include "cli/notice.hpp"

#include <optional>
#include <string>

namespace maclint::cli {

/// A pipe or a device in the place of a file that git reads would stop it for ever.
[[nodiscard]] std::optional<Notice> refuse_special_files(const std::string& root);

/// Windows opens the share of any server that a .git names; only the one that holds the repository may be.
[[nodiscard]] std::optional<Notice> refuse_other_servers(const std::string& root);

/// Whether only a part of the revision's files was written to the working tree: what is not there is not
/// gone.
[[nodiscard]] bool is_sparse(const std::string& root);

} // namespace maclint::cli
