//! Workflow commands of GitHub Actions, which mark findings in the files of a pull request:
//! ::error file=O1.nc,line=4,col=1,endLine=4,endColumn=7,title=MAC303 jump-into-loop::message
#include "analyzer/source/encoding.hpp"
#include "cli/config/rule_words.hpp"
#include "cli/report/service.hpp"
#include "cli/report/uri.hpp"

namespace maclint::cli {
namespace {

std::string_view command_of(Severity severity) {
    return severity == Severity::note ? "notice" : name_of(severity);
}

/// What the runner takes back in a message: it reads commands line by line.
std::string escaped_message(std::string_view text) {
    std::string out;
    for (const char c : text) {
        switch (c) {
        case '%': out += "%25"; break;
        case '\r': out += "%0D"; break;
        case '\n': out += "%0A"; break;
        default: out += c;
        }
    }
    return out;
}

/// In a property these two end it.
std::string escaped_property(std::string_view text) {
    std::string out;
    for (const char c : escaped_message(text)) {
        switch (c) {
        case ':': out += "%3A"; break;
        case ',': out += "%2C"; break;
        default: out += c;
        }
    }
    return out;
}

/// Columns go with one line only: GitHub refuses them otherwise.
std::string place_of(const Finding& finding) {
    const Position begin = finding.source->position(finding.span.begin);
    const Position end = finding.source->position(finding.span.end);
    std::string place = ",line=" + std::to_string(begin.line) + ",endLine=" + std::to_string(end.line);
    if (begin.line == end.line)
        place += ",col=" + std::to_string(begin.column) + ",endColumn=" + std::to_string(end.column);
    return place;
}

} // namespace

std::string write_github(const Report& report, const TextStyle& style) {
    const std::string root = source_root();
    std::string out;
    for (const Notice* notice : run_errors(report)) {
        out += "::error title=maclint";
        if (!notice->path.empty()) out += ",file=" + escaped_property(service_path(notice->path, root));
        out += "::" + escaped_message(printable(notice->message)) + "\n";
    }
    for (const auto& [finding, suppressed] : report.findings) {
        if (suppressed) continue;
        const std::string title = code_with_key(finding) + " " + std::string(finding.rule->name);
        std::string message = printable(finding.message());
        for (const std::string& step : steps_of(finding, style.path, root)) message += "\n" + step;
        out += "::" + std::string(command_of(finding.severity)) +
               " file=" + escaped_property(service_path(finding.source->path(), root)) + place_of(finding) +
               ",title=" + escaped_property(title) + "::" + escaped_message(message) + "\n";
    }
    if (style.summary == Summary::at_the_end) out += summary_line(report) + "\n";
    return out;
}

} // namespace maclint::cli
