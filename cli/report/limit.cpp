//! Chooses findings by their severity.
#include "cli/report/limit.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <utility>

namespace maclint::cli {
namespace {

/// Of a finding that counts; none of a suppressed one.
std::optional<Severity> counted_severity(const FilteredFinding& filtered) {
    return filtered.suppressed ? std::nullopt : std::optional(filtered.finding.severity);
}

std::size_t count_of(const Report& report, Severity severity) {
    return static_cast<std::size_t>(
        std::ranges::count(report.findings, std::optional(severity), counted_severity));
}

} // namespace

void limit(Report& report, std::size_t most) {
    std::array<std::size_t, 3> room{}; // for each severity
    for (const Severity severity : {Severity::error, Severity::warning, Severity::note}) {
        room.at(static_cast<std::size_t>(severity)) = most;
        most -= std::min(most, count_of(report, severity));
    }
    std::vector<FilteredFinding> all = std::exchange(report.findings, {});
    for (FilteredFinding& filtered : all) {
        std::size_t& left = room.at(static_cast<std::size_t>(filtered.finding.severity));
        const bool kept = filtered.suppressed || left > 0;
        if (!filtered.suppressed && left > 0) --left;
        (kept ? report.findings : report.not_shown).push_back(std::move(filtered));
    }
}

void fit_terminal(Report& report) {
    limit(report, most_on_terminal);
    if (report.not_shown.empty()) return;
    std::ranges::stable_sort(report.findings, std::ranges::greater(),
                             [](const FilteredFinding& filtered) { return filtered.finding.severity; });
}

} // namespace maclint::cli
