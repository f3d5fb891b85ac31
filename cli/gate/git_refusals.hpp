//! Repositories that git is not asked about, because of where it would look; they are read without following.
#pragma once

#include "cli/gate/git_call.hpp"
#include "cli/notice.hpp"

#include <optional>
#include <string>

namespace maclint::cli {

/// A pipe or a device in the place of a file that git reads would stop it for ever, and of one that a link
/// leads to elsewhere it may say the text.
[[nodiscard]] std::optional<Notice> refuse_special_files(const std::string& root);

/// Windows opens the share of any server that a .git names; only the one that holds the repository may be.
[[nodiscard]] std::optional<Notice> refuse_other_servers(const GitPlace& place);

} // namespace maclint::cli
