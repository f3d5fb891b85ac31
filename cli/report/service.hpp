//! What the report formats of build services have in common.
#pragma once

#include "cli/report/report.hpp"

#include <string>
#include <vector>

namespace maclint::cli {

/// A path as services name files: below the root of the sources relative to it, else absolute, with '/', in
/// UTF-8 without control characters.
[[nodiscard]] std::string service_path(const std::string& path, const std::string& root);

/// The findings of one file that no comment allows.
struct FileFindings {
    const Source* source;
    std::vector<const Finding*> findings;
};
/// All files that were checked, those without findings too, then others that findings are in.
[[nodiscard]] std::vector<FileFindings> findings_by_file(const Report& report);

/// What the run could not do; services hear of it, or a report without findings would pass for a clean one.
[[nodiscard]] std::vector<const Notice*> run_errors(const Report& report);

/// The path of a finding and what else is said of it: "O1.nc:7: this sequence number is inside the loop".
[[nodiscard]] std::vector<std::string> steps_of(const Finding& finding, PathDetail detail,
                                                const std::string& root);

} // namespace maclint::cli
