//! Runs another program.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace maclint::platform {

struct ProcessEnd {
    bool started = false; ///< otherwise there is no such program, or it must not run
    int status = 0;       ///< exit status; 127: nobody knows; 128 and more: a signal ended it
    std::string errors;   ///< beginning of what it wrote to standard error
};

/// Runs a program that PATH leads to, with nothing as its standard input; no shell sees the words. `take`
/// gets its standard output part by part.
[[nodiscard]] ProcessEnd run_process(const std::vector<std::string>& words,
                                     const std::function<void(std::string_view part)>& take);

} // namespace maclint::platform
