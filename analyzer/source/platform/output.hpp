//! Writing files whole or not at all. Results are 0, or what errno has for the failure.
#pragma once

#include <chrono>
#include <filesystem>
#include <string>
#include <string_view>

namespace maclint::platform {

/// How long a pipe that is written may be without a reader.
inline constexpr std::chrono::seconds patience_with_readers{10};

/// Where a file of that name is, or goes in the end, all links followed: absolute. It need not be there yet.
[[nodiscard]] std::filesystem::path place_of(const std::filesystem::path& path);
/// The same as text.
[[nodiscard]] std::string written_path(const std::string& path);

/// Puts a file with that text in the place of the old one. Whoever stops the run, or a full disk, leaves the
/// old file as it was.
[[nodiscard]] int replace_file(const std::string& path, std::string_view text);

/// Takes away the new file of `replace_file`, if there is one just now: the run is about to end at once.
void remove_unfinished() noexcept;

/// Whether the path means what this process has open, whatever that is: /dev/stderr, /dev/fd/3, or a link to
/// these. Windows has no such names.
[[nodiscard]] bool names_open_file(const std::string& path);

/// Writes to a pipe, a device or what is open, there behind what was written before. ENXIO: nobody came to
/// read the pipe.
[[nodiscard]] int write_in_place(const std::string& path, std::string_view text);

/// Whether the path means standard output wherever that goes: /dev/stdout. Windows has no such name.
[[nodiscard]] bool names_standard_output(const std::string& path);

/// Whether the path names the file or the pipe that standard output goes to. A terminal and other devices may
/// well be written twice.
[[nodiscard]] bool is_standard_output(const std::string& path);

} // namespace maclint::platform
