//! Counts findings and says so in one line.
#include "cli/fix/choose.hpp"
#include "cli/report/report.hpp"
#include "cli/text/shown.hpp"

#include <map>
#include <unordered_set>

namespace maclint::cli {

Tally tally(const Report& report) {
    Tally tally;
    std::unordered_set<const Source*> files;
    for (const auto* findings : {&report.findings, &report.not_shown}) {
        for (const FilteredFinding& filtered : *findings) {
            if (filtered.suppressed) {
                ++(is_withheld(filtered)    ? tally.withheld
                   : is_of_vendor(filtered) ? tally.vendor
                   : is_known(filtered)     ? tally.known
                                            : tally.suppressed);
                continue;
            }
            const Finding& finding = filtered.finding;
            files.insert(finding.source.get());
            switch (finding.severity) {
            case Severity::error: ++tally.errors; break;
            case Severity::warning: ++tally.warnings; break;
            case Severity::note: ++tally.notes; break;
            }
        }
    }
    tally.files = files.size();
    return tally;
}

std::vector<std::string> exemptions_of(const FilteredFinding& filtered) {
    std::vector<std::string> names;
    for (const NamedExemption& exemption : withheld_by(filtered.finding)) names.push_back(exemption.name());
    return names;
}

std::string summary_line(const Report& report) {
    const Tally counts = tally(report);
    std::vector<std::string> parts;
    if (counts.errors > 0) parts.push_back(counted(counts.errors, "error"));
    if (counts.warnings > 0) parts.push_back(counted(counts.warnings, "warning"));
    if (counts.notes > 0) parts.push_back(counted(counts.notes, "note"));
    std::string line;
    for (const std::string& part : parts) line += (line.empty() ? "" : ", ") + part;
    line = parts.empty() ? (counts.known > 0 ? "no new findings" : "no findings")
                         : line + " in " + counted(counts.files, "file");
    line += " (" + std::to_string(report.files.size()) + " checked";
    if (counts.suppressed > 0) line += ", " + std::to_string(counts.suppressed) + " allowed by comments";
    if (report.withheld == Withheld::listed) line += ", " + std::to_string(counts.withheld) + " withheld";
    if (const std::string text = text_of(report.passed_over); !text.empty()) line += ", " + text;
    if (!report.not_shown.empty())
        line += ", " + std::to_string(report.not_shown.size()) + " not shown: see --max-findings";
    return line + ")";
}

std::string fix_line(const Report& report) {
    std::size_t count = 0;
    for (const FilteredFinding& filtered : report.findings)
        if (!filtered.suppressed && wanted_fix(filtered.finding, FixesWanted::safe) != nullptr) ++count;
    if (count == 0) return "";
    return counted(count, "finding") + " can be corrected by --fix; --diff shows how\n";
}

std::string known_lines(const Report& report) {
    std::map<std::string, std::size_t> counts;
    for (const FilteredFinding& filtered : report.findings)
        if (is_known(filtered)) ++counts[filtered.suppressed->baseline];
    std::string lines;
    for (const auto& [path, count] : counts)
        lines += counted(count, "known finding") + " of " + shown(path) + " not shown\n";
    return lines;
}

} // namespace maclint::cli
