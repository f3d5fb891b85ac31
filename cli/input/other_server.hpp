//! Paths that make Windows ask another server for a file, which tells that server who asks. They are known by
//! their text, before anything is opened, and everywhere: one configuration says the same on all systems.
#pragma once

#include <filesystem>
#include <string_view>

namespace maclint::cli {

/// Whether a path, as it is written somewhere, begins with a server (`\\server\share`, `//server/share`)
/// whose share `from`, an absolute path, is not on, or with a device (`\\.\`, `\\?\`).
[[nodiscard]] bool names_other_server(std::string_view written, std::string_view from);

/// Whether it begins with a drive that is not the one of `from`, or is relative to a drive (`D:shop.json`).
[[nodiscard]] bool names_other_drive(std::string_view written, std::string_view from);

/// Whether one of the links on the way to an absolute path names such a server. None of them is followed.
[[nodiscard]] bool leads_to_other_server(const std::filesystem::path& path, std::string_view from);

} // namespace maclint::cli
