//! Writing reports: a file is written whole or not at all, whatever ends the run.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace maclint::cli {

/// Replaces the file when all is written; a pipe or a device is written as it is. Why it could not be, in
/// words for the user, or nothing.
[[nodiscard]] std::optional<std::string> write_file(const std::string& path, std::string_view text);

/// The same for standard output.
[[nodiscard]] std::optional<std::string> write_output(std::string_view text);

} // namespace maclint::cli
