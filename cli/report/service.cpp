//! Findings by file, paths and steps in words.
#include "cli/report/service.hpp"

#include "analyzer/source/encoding.hpp"
#include "cli/report/rows.hpp"
#include "cli/report/uri.hpp"
#include "cli/text/shown.hpp"

#include <unordered_map>

namespace maclint::cli {

std::string service_path(const std::string& path, const std::string& root) {
    return shown(placed_path(path, root).path);
}

std::vector<FileFindings> findings_by_file(const Report& report) {
    std::vector<FileFindings> files;
    std::unordered_map<const Source*, std::size_t> index;
    const auto file_of = [&](const Source& source) -> FileFindings& {
        const auto [entry, is_new] = index.try_emplace(&source, files.size());
        if (is_new) files.push_back({&source, {}});
        return files[entry->second];
    };
    for (const auto& source : report.files) file_of(*source);
    for (const FilteredFinding& filtered : report.findings)
        if (!filtered.suppressed) file_of(*filtered.finding.source).findings.push_back(&filtered.finding);
    return files;
}

std::vector<const Notice*> run_errors(const Report& report) {
    std::vector<const Notice*> errors;
    for (const Notice& notice : report.notices)
        if (notice.is_error()) errors.push_back(&notice);
    return errors;
}

std::vector<std::string> steps_of(const Finding& finding, PathDetail detail, const std::string& root) {
    std::vector<std::string> steps;
    for (const Row& row : rows_of(finding, detail, Remarks::alone).rows) {
        if (row.remark.empty()) continue;
        steps.push_back(service_path(row.source->path(), root) + ":" + std::to_string(row.line) + ": " +
                        printable(row.remark));
    }
    return steps;
}

} // namespace maclint::cli
