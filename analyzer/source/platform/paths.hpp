//! Paths as text: what maclint holds and shows, against what the system wants.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace maclint::platform {

/// Whether a path may lead to another computer that nobody has connected: `\\server\share` on Windows.
[[nodiscard]] bool paths_may_name_servers();

/// The path that a text names: UTF-8 on Windows, where the constructor of a path takes it for something else;
/// any bytes elsewhere.
[[nodiscard]] std::filesystem::path path_of(std::string_view text);

/// The text of a path, with '/' between names on Windows, too.
[[nodiscard]] std::string text_of(const std::filesystem::path& path);

} // namespace maclint::platform
