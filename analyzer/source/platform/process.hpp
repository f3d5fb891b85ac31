//! Runs another program.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace maclint::platform {

struct ProcessRequest {
    std::vector<std::string> words; ///< the first names the program
    std::string_view input = {};    ///< what it reads from its standard input
    std::string_view left_out_prefix =
        {};                             ///< variables whose names begin so do not reach it; none when empty
    std::vector<std::string> kept = {}; ///< names of variables that reach it nevertheless
    /// Of those that hold a path, relative to the current folder: they reach it, and the path is absolute.
    std::vector<std::string> paths = {};
    std::vector<std::string> set = {}; ///< NAME=value, in place of what was there
    /// Folders, absolute and without links. No program is run that PATH leads to through one of them, as it
    /// is written or when links are followed, or that lies there.
    std::vector<std::string> not_below = {};
    std::chrono::milliseconds patience{60'000}; ///< how long it may neither read nor write before it is ended
    std::chrono::milliseconds longest{600'000}; ///< how long it may take in all
};

enum class EndedBy : std::uint8_t {
    nothing_started, ///< there is no such program, or it must not run
    itself,
    silence, ///< it let the patience pass
    time,    ///< it took the longest time
    taker,   ///< who takes its output wanted no more
};

struct ProcessEnd {
    EndedBy by = EndedBy::nothing_started;
    int status = 0;               ///< exit status; 127: nobody knows; 128 and more: a signal ended it
    std::string errors;           ///< beginning of what it wrote to standard error
    std::string passed_over = {}; ///< a program of that name that must not run, when no other was found

    [[nodiscard]] bool succeeded() const { return by == EndedBy::itself && status == 0; }
};

/// Gets the standard output part by part; false: no more is wanted.
using TakeOutput = std::function<bool(std::string_view part)>;

/// Runs a program that an absolute entry of PATH leads to; no shell sees the words.
[[nodiscard]] ProcessEnd run_process(const ProcessRequest& request, const TakeOutput& take);

} // namespace maclint::platform
