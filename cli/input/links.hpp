//! Where links lead, found out link by link: nothing that lies elsewhere is opened for it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>

namespace maclint::cli {

/// Whether a link may be followed whose target is written so.
using MayFollow = std::function<bool(const std::filesystem::path& target)>;

/// The end of an absolute path when all links on the way are followed, whether anything is there or not;
/// nothing where one may not be followed, or they lead in a circle.
[[nodiscard]] std::optional<std::filesystem::path> follow_links(const std::filesystem::path& path,
                                                                const MayFollow& may_follow);

enum class LinkEnd : std::uint8_t {
    inside,  ///< one of the folders, whether anything is there or not
    outside, ///< all of them
    nowhere, ///< but in a circle
};

/// Where a path leads when all links in it are followed; the path and the folders are absolute. Another drive
/// or server than theirs is not asked for anything.
[[nodiscard]] LinkEnd end_of(const std::filesystem::path& path,
                             std::span<const std::filesystem::path> folders);

/// Whether a path leads to another drive, or to the share of another server, than its folder is on: on
/// Windows to open that sends a user's name there. Elsewhere there are no such paths. The folder is absolute.
[[nodiscard]] bool leaves_drive(const std::filesystem::path& path, const std::filesystem::path& folder);

} // namespace maclint::cli
