//! One line a finding: file:line:column: error[MAC303] message.
#include "cli/config/rule_words.hpp"
#include "cli/report/ansi_style.hpp"
#include "cli/report/report.hpp"
#include "cli/report/statistics.hpp"
#include "cli/text/shown.hpp"
#include "rules/listed.hpp"

namespace maclint::cli {

namespace {

void add_line(const Finding& finding, const AnsiStyle& ansi, const std::string& end, std::string& out) {
    const Source& source = *finding.source;
    const Position at = source.position(finding.span.begin);
    out += shown(source.path()) + ":" + std::to_string(at.line) + ":" + std::to_string(at.column) + ": ";
    out += ansi.severity(finding.severity,
                         std::string(name_of(finding.severity)) + "[" + code_with_key(finding) + "]");
    out += " " + printable(finding.message()) + end + "\n";
}

} // namespace

std::string write_concise(const Report& report, const TextStyle& style) {
    const AnsiStyle ansi(style.colour);
    std::string out;
    for (const FilteredFinding& filtered : report.findings)
        if (!filtered.suppressed) add_line(filtered.finding, ansi, "", out);
    for (const FilteredFinding& filtered : report.findings)
        if (is_withheld(filtered))
            add_line(filtered.finding, ansi,
                     " Withheld by " + rules::listed(exemptions_of(filtered), " and ") + ".", out);
    if (report.statistics) out += statistics_text(report);
    if (style.summary == Summary::at_the_end) out += summary_line(report) + "\n" + known_lines(report);
    return out;
}

} // namespace maclint::cli
