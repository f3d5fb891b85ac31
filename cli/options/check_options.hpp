//! The options of `check`.
#pragma once

#include "cli/command_line.hpp"

#include <string>
#include <vector>

namespace CLI { // NOLINT(readability-identifier-naming): the library's
class App;
}

namespace maclint::cli {

/// Options of `check` as they were typed.
struct CheckWords {
    std::vector<std::string> paths, outputs, select, ignore, severity, without_exemption, codes, lacks, calls,
        options;
    std::string format, dialect = "auto", control, config, stdin_name, jobs, fail_on = "warning",
                        max_findings, max_file_size, path = "short", colour = "auto", baseline,
                        write_baseline, since, axes, reason;
    bool isolated = false, show_config = false, show_files = false, quiet = false, no_timestamps = false,
         timing = false, statistics = false, no_baseline = false, prune_baseline = false,
         fail_on_gone = false, force_exclude = false, no_gitignore = false, follow_links = false,
         error_on_empty = false, vendor = false, show_withheld = false, fix = false, unsafe_fixes = false,
         diff = false, add_suppressions = false;
};

void declare_check(CLI::App& check, CheckWords& words);

/// Threads that `--jobs` asks for; empty: one a core.
[[nodiscard]] unsigned jobs_in(const std::string& word);

/// What they ask for; throws Refused where they make no sense.
[[nodiscard]] CheckRequest check_request(const CheckWords& words);

} // namespace maclint::cli
