//! What the system knows of files and folders. On Windows paths of more than 260 characters are known, too.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

namespace maclint::platform {

enum class FileKind : std::uint8_t {
    missing,     ///< or in a folder that cannot be looked at
    broken_link, ///< that leads nowhere, or in a circle
    regular,
    folder,
    pipe,
    other, ///< a device, a socket
    link,  ///< to a file or folder; only where links are not followed
};

/// What is there, all links followed.
[[nodiscard]] FileKind kind_of(const std::filesystem::path& path);
FileKind kind_of(const std::string& text) = delete; // path_of makes a path of it

/// What bears the name, be it a link: nothing that lies elsewhere is looked at.
[[nodiscard]] FileKind kind_unfollowed(const std::filesystem::path& path);

/// What a link says where it leads, absolute or relative to its folder; nothing: it is no link. Where the
/// system keeps that to itself it is a path in no folder.
[[nodiscard]] std::optional<std::filesystem::path> link_target(const std::filesystem::path& path);

/// Whether a path is the folder's or one below it: both absolute, without links, "." and "..".
[[nodiscard]] bool lies_in(const std::filesystem::path& path, const std::filesystem::path& folder);

/// Whether two paths lead to one file or folder that is there.
[[nodiscard]] bool are_same_file(const std::filesystem::path& one, const std::filesystem::path& other);

/// Absolute, all links followed; nothing is there: an error.
[[nodiscard]] std::filesystem::path real_path(const std::filesystem::path& path, std::error_code& error);

/// The user's own folder as the environment names it; nothing: it names none.
[[nodiscard]] std::optional<std::filesystem::path> home_folder();

/// Users by their numbers.
struct Ownership {
    std::uint64_t owner;  ///< of a file, all links followed
    std::uint64_t runner; ///< of this run
};

/// Nothing where the file cannot be looked at, and on Windows, where users have no numbers.
[[nodiscard]] std::optional<Ownership> ownership_of(const std::filesystem::path& path);

/// Bytes of a file, 0 when it cannot be looked at.
[[nodiscard]] std::uintmax_t size_of(const std::filesystem::path& path);

/// What a file's content does not change without.
struct FileStamp {
    std::uint64_t size;     ///< bytes
    std::uint64_t identity; ///< of the file among those of its volume
    std::int64_t written;   ///< when its content was; in steps of the system
    std::int64_t changed;   ///< when anything of it was, where the system tells
    friend bool operator==(const FileStamp&, const FileStamp&) = default;
};

/// All links followed. Nothing where the file cannot be looked at, or was written in the last two seconds: as
/// coarse are the clocks of some volumes, which give one stamp to two contents then.
[[nodiscard]] std::optional<FileStamp> settled_stamp_of(const std::filesystem::path& path);

struct FolderEntry {
    std::filesystem::path path; ///< that of the folder with the entry's name
    FileKind kind;              ///< a link is not followed
    bool lies_here; ///< in the folder that was asked; false: a link, or what may be one and not show it
};

/// What is in a folder, in no order.
[[nodiscard]] std::vector<FolderEntry> entries_of(const std::filesystem::path& folder,
                                                  std::error_code& error);

} // namespace maclint::platform
