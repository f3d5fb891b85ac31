//! The repository that a folder belongs to.
#pragma once

#include <filesystem>
#include <optional>

namespace maclint::cli {

/// Whether the folder itself holds one: a .git that is a folder, or a file that names one.
[[nodiscard]] bool is_repository(const std::filesystem::path& folder);

/// The nearest folder upward, the folder itself included, that holds a repository.
[[nodiscard]] std::optional<std::filesystem::path> repository_around(const std::filesystem::path& folder);

} // namespace maclint::cli
