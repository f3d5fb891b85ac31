//! Runs the built executable, or the one that the environment names as MACLINT_EXECUTABLE.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace maclint::test {

struct Finished {
    int status; ///< exit status, or 128 and the signal that ended it
    std::string out;
    std::string err;
};

/// Runs maclint in a folder with `input` as its standard input.
[[nodiscard]] Finished run_maclint(const std::string& folder, const std::vector<std::string>& arguments,
                                   const std::string& input);

/// Runs a script of the shell in a folder, where "$maclint" is the executable.
[[nodiscard]] Finished run_shell(const std::string& folder, const std::string& script);

/// The same as run_maclint on a terminal of so many columns; `out` is all that it shows.
[[nodiscard]] Finished run_maclint_on_terminal(const std::string& folder,
                                               const std::vector<std::string>& arguments,
                                               unsigned short columns);

/// The same as a user who may not read everything, whoever runs the tests; nothing when that cannot be had.
[[nodiscard]] std::optional<Finished>
run_maclint_without_privileges(const std::string& folder, const std::vector<std::string>& arguments);

} // namespace maclint::test
