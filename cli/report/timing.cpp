//! One row a part: the time, and what it was spent on.
#include "cli/report/timing.hpp"

#include "cli/text/shown.hpp"

#include <array>
#include <cstdio>
#include <string_view>

namespace maclint::cli {
namespace {

std::string row(std::string_view part, std::chrono::nanoseconds time, const std::string& what) {
    std::array<char, 64> text{};
    const double seconds = std::chrono::duration<double>(time).count();
    const int length =
        std::snprintf(text.data(), text.size(), "timing: %-16s %8.3f s", std::string(part).c_str(), seconds);
    std::string line(text.data(), static_cast<std::size_t>(length));
    if (!what.empty()) line += "  " + what;
    return line + "\n";
}

std::string megabytes(std::size_t bytes) {
    constexpr double mega = 1e6;
    std::array<char, 32> text{};
    const int length = std::snprintf(text.data(), text.size(), "%.2f MB", static_cast<double>(bytes) / mega);
    return {text.data(), static_cast<std::size_t>(length)};
}

std::string searches(const Timing& engine) {
    return counted(engine.searches, "path") + " looked for, " + std::to_string(engine.searches_given_up) +
           " given up";
}

} // namespace

std::string write_timing(const Timing& engine, const RunTiming& run) {
    return row("finding files", run.finding, {}) +
           row("reading", engine.reading, counted(engine.files, "file") + ", " + megabytes(engine.bytes)) +
           row("analysis", engine.analysis, counted(engine.programs, "program")) +
           row("rules", engine.rules, searches(engine)) + row("reports", run.reports, {}) +
           row("the whole run", run.whole, {});
}

} // namespace maclint::cli
