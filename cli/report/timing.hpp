//! Where the time of a run went, for people.
#pragma once

#include "cli/engine/timing.hpp"

#include <chrono>
#include <string>

namespace maclint::cli {

/// The times around the engine's: of finding the files, of writing the reports, and of the whole run.
struct RunTiming {
    std::chrono::nanoseconds finding{}, reports{}, whole{};
};

/// A line for each part of the run. Times of parts that run on several threads are added up, so they can be
/// longer than the run.
[[nodiscard]] std::string write_timing(const Timing& engine, const RunTiming& run);

} // namespace maclint::cli
