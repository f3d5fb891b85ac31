//! Repositories that strangers may send: what their .git says, and what --since makes of it. Add a row for
//! what you think of.
#pragma once

#include <span>
#include <string_view>
#include <vector>

namespace maclint::test {

/// A setting of git that names a command, a place to write to, or one to fetch from.
struct HostileSetting {
    std::string_view key;
    std::string_view value;  ///< "$ran" is the command
    std::string_view source; ///< of git's documentation
};

/// All of them. Where the documentation has <driver>, <name> and the like, it is x, which
/// .git/info/attributes gives to all programs and which is the name of a promisor remote.
[[nodiscard]] std::span<const HostileSetting> hostile_settings();

/// Names of githooks(5).
[[nodiscard]] std::span<const std::string_view> hook_names();

/// What the shell makes of a repository with one commit whose O1001.nc was changed on line 5 since; --since
/// runs in the folder that the script ends in. "$repository" is the folder it begins in, "$ran" the command
/// that must not run, "$all" a file with all settings above, "$hooks" the names of hooks, "$outside" a folder
/// beside.
struct HostileRepository {
    std::string_view name;
    std::string_view script;
    std::string_view refusal; ///< part of the message that ends the run; empty: the finding is shown
};

[[nodiscard]] std::span<const HostileRepository> hostile_repositories();

/// The same, where the text of O1001.nc as it was is gone and a remote has promised it, as in a partial
/// clone.
[[nodiscard]] std::span<const HostileRepository> hostile_promisors();

} // namespace maclint::test
