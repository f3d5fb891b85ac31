//! Paths of the files that URIs name.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace maclint::cli::lsp {

/// The absolute path, with '/' between names; nothing where the URI names no file of this machine's systems.
[[nodiscard]] std::optional<std::string> path_of_uri(std::string_view uri);

} // namespace maclint::cli::lsp
