//! The repository that a folder belongs to.
#pragma once

#include <filesystem>
#include <optional>

namespace maclint::cli {

/// The nearest folder upward, the folder itself included, that holds a repository.
[[nodiscard]] std::optional<std::filesystem::path> repository_around(const std::filesystem::path& folder);

} // namespace maclint::cli
