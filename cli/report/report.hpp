//! What a run found, ready to be written in any format.
#pragma once

#include "cli/engine/read_as.hpp"
#include "cli/filter/apply_suppressions.hpp"
#include "cli/input/passed_over.hpp"
#include "cli/notice.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace maclint::cli {

/// Begin and end of the run, UTC, as SARIF writes them: "2025-01-31T12:00:00Z".
struct RunTimes {
    std::string begin, end;
};

struct Report {
    std::vector<FilteredFinding> findings; ///< in the order of reports, suppressed ones included
    std::vector<Notice> notices;           ///< in the order of paths
    std::vector<std::shared_ptr<const Source>>
        files; ///< that were linted because the user asked for them, by path
    std::unordered_map<const Source*, ReadAs> read_as; ///< each of `files`
    std::vector<FilteredFinding> not_shown;            ///< left out of `findings` because of --max-findings
    PassedOver passed_over;
    bool has_baseline = false; ///< known findings are told from new ones
    int exit_status = 0;
    std::optional<RunTimes> times;   ///< none with --no-timestamps
    std::optional<Severity> fail_on; ///< the least severity that counts as a failure; none: nothing does
    bool statistics = false;         ///< numbers by rule and by file are wanted
    Withheld withheld = Withheld::dropped;
};

/// How many findings of each severity count, shown or not; those that comments allow, that a baseline knows,
/// that are vendor code's and that exemptions hold back apart.
struct Tally {
    std::size_t errors = 0, warnings = 0, notes = 0, suppressed = 0, known = 0, vendor = 0, withheld = 0,
                files = 0;
};
[[nodiscard]] Tally tally(const Report& report);

/// Whether a baseline knows the finding.
[[nodiscard]] inline bool is_known(const FilteredFinding& filtered) {
    return filtered.suppressed && !filtered.suppressed->baseline.empty();
}

/// Whether it is withheld because it stands in a maker's program.
[[nodiscard]] inline bool is_of_vendor(const FilteredFinding& filtered) {
    return filtered.suppressed && filtered.suppressed->vendor;
}

/// Whether exemptions of its rule hold it back: it is there because --show-withheld asks for it.
[[nodiscard]] inline bool is_withheld(const FilteredFinding& filtered) {
    return filtered.finding.withheld != 0;
}
/// "MAC319/waits-for-others", one for each exemption that holds it back.
[[nodiscard]] std::vector<std::string> exemptions_of(const FilteredFinding& filtered);

enum class Colour : std::uint8_t { plain, coloured };
enum class Summary : std::uint8_t { left_out, at_the_end };

/// How much of the paths of findings a text report shows.
enum class PathDetail : std::uint8_t { none, shortened, full };
/// Columns of a text report that does not go to a terminal.
inline constexpr std::size_t usual_width = 80;
/// The least and the most columns of one that does.
inline constexpr std::size_t least_width = 40;
inline constexpr std::size_t most_width = 120; // longer lines are hard to read

struct TextStyle {
    Colour colour = Colour::plain;
    Summary summary = Summary::at_the_end;
    PathDetail path = PathDetail::shortened;
    std::size_t width = usual_width; ///< columns
};

[[nodiscard]] std::string write_text(const Report& report, const TextStyle& style);
[[nodiscard]] std::string write_concise(const Report& report, const TextStyle& style);
[[nodiscard]] std::string write_json(const Report& report);
[[nodiscard]] std::string write_sarif(const Report& report);
[[nodiscard]] std::string write_github(const Report& report, const TextStyle& style);
[[nodiscard]] std::string write_gitlab(const Report& report, const TextStyle& style);
[[nodiscard]] std::string write_junit(const Report& report, const TextStyle& style);
[[nodiscard]] std::string write_checkstyle(const Report& report);

/// "3 errors, 2 warnings in 2 files (41 checked)".
[[nodiscard]] std::string summary_line(const Report& report);

/// "12 known findings of baseline.json not shown", a line a baseline; empty: there are none.
[[nodiscard]] std::string known_lines(const Report& report);
/// How many of them have a fix that --fix takes; a line, or nothing.
[[nodiscard]] std::string fix_line(const Report& report);

} // namespace maclint::cli
