//! Runs the built executable.
#pragma once

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

} // namespace maclint::test
