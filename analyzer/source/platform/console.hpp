//! The command line, standard output and standard error.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace maclint::platform {

/// The words behind the program's name, on Windows in UTF-8.
[[nodiscard]] std::vector<std::string> arguments(int count, char** words);

/// Whether `*.nc` comes as the names of files; where not, the program has to look for them.
[[nodiscard]] bool shell_expands_wildcards();

enum class Stream : std::uint8_t { output, error };

enum class Terminal : std::uint8_t {
    none,
    plain,   ///< shows the escape sequences of ECMA-48 as they are
    escapes, ///< understands them
};

[[nodiscard]] Terminal terminal_at(Stream stream);

/// How wide the terminal at standard output is; nothing where there is none.
[[nodiscard]] std::optional<std::size_t> terminal_columns();

/// Writes UTF-8, byte by byte as it is but for the console of Windows, which is given characters whatever its
/// code page. Gives 0, or what errno has for the failure.
[[nodiscard]] int write(Stream stream, std::string_view text);

} // namespace maclint::platform
