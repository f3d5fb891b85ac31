//! What the user asked for.
#pragma once

#include "cli/config/settings.hpp"
#include "cli/fix/choose.hpp"
#include "cli/input/discover.hpp"
#include "cli/renumber/numbering.hpp"
#include "cli/report/report.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace maclint::cli {

enum class Format : std::uint8_t { text, concise, json, sarif, github, gitlab, junit, checkstyle };

/// One place where a report goes.
struct Sink {
    Format format;
    std::string path; ///< "-": standard output
};

enum class ColourChoice : std::uint8_t { automatic, always, never };
enum class ShowConfig : std::uint8_t { no, yes };
enum class ShowFiles : std::uint8_t { no, yes };

/// What becomes of the fixes that findings carry.
enum class FixUse : std::uint8_t {
    reported, ///< in reports that have a place for them
    written,  ///< programs are changed
    shown,    ///< as a difference, in place of findings
};

enum class ListFormat : std::uint8_t { text, json, markdown };

struct CheckRequest {
    std::vector<std::string> paths;
    std::vector<Sink> sinks;
    Overrides overrides;
    ShowConfig show_config = ShowConfig::no;
    ListFormat config_format = ListFormat::text; ///< of --show-config
    ShowFiles show_files = ShowFiles::no;
    std::string stdin_name;
    unsigned jobs = 1;
    std::optional<Severity> fail_on;         ///< nothing: never
    std::optional<std::size_t> max_findings; ///< nothing: all, but on a terminal so many as fit
    PathDetail path = PathDetail::shortened;
    ColourChoice colour = ColourChoice::automatic;
    bool quiet = false;
    bool timestamps = true;
    bool timing = false;        ///< say where the time went
    bool statistics = false;    ///< count findings by rule and by file
    std::string write_baseline; ///< file for what is found; empty: none
    bool prune_baseline = false;
    bool fail_on_gone = false; ///< a baseline with entries that are gone counts as findings do
    std::string since;         ///< git revision; empty: all findings count
    DiscoverOptions discovery;
    bool error_on_empty = false; ///< a run that checks no program is an error
    ExemptionChoice exemptions;
    FixUse fix_use = FixUse::reported;
    std::string
        allowing_reason; ///< of --add-suppressions, whose comments take the place of fixes; empty: none
    FixesWanted fixes_wanted = FixesWanted::safe;
};

struct RulesRequest {
    ListFormat format = ListFormat::text;
    std::string docs_folder;  ///< write pages there instead; empty: no
    std::string codes_folder; ///< and those of codes there
    std::string alarms_file;  ///< and the list of alarms there
};

struct ExplainRequest {
    std::string rule;
    ColourChoice colour = ColourChoice::automatic;
    const Dialect* dialect = nullptr;      ///< of a code; nullptr: of any language
    const ControlModel* control = nullptr; ///< of a code, a variable, an alarm; nullptr: of any
    ListFormat format = ListFormat::text;
};

struct ControlsRequest {
    ListFormat format = ListFormat::text;
    const ControlModel* control = nullptr; ///< all that is known of it; nullptr: a line for each
    ColourChoice colour = ColourChoice::automatic;
};

struct InitRequest {
    std::string folder = ".";
    bool print = false; ///< show what would be written, and write nothing
};

struct RenumberRequest {
    std::vector<std::string> paths; ///< one at least
    Overrides overrides;
    Numbering numbering;
    bool diff = false; ///< show what would change, and change nothing
};

struct LspRequest {
    unsigned jobs = 1; ///< threads of the engine
};

/// Text to be printed instead of doing anything: help, version.
struct PrintRequest {
    std::string text;
};

struct UsageError {
    std::string message; ///< "what. Cure."
};

using Request = std::variant<CheckRequest, RulesRequest, ExplainRequest, ControlsRequest, InitRequest,
                             RenumberRequest, LspRequest, PrintRequest, UsageError>;

/// `arguments` without the program's name.
[[nodiscard]] Request read_command_line(std::vector<std::string> arguments);

} // namespace maclint::cli
