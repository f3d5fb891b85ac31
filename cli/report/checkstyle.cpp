//! Checkstyle's XML: a list of errors for each file, empty for those without findings.
#include "analyzer/source/encoding.hpp"
#include "cli/config/rule_words.hpp"
#include "cli/report/rule_page.hpp"
#include "cli/report/service.hpp"
#include "cli/report/uri.hpp"
#include "cli/report/xml.hpp"

#include <algorithm>

namespace maclint::cli {
namespace {

std::string_view severity_of(Severity severity) {
    return severity == Severity::note ? "info" : name_of(severity);
}

/// "loops-and-jumps"
std::string category_of(const Rule& rule) {
    std::string words(family_of(rule));
    std::ranges::replace(words, ' ', '-');
    return words;
}

/// Readers show what stands behind the last point of a source as the type, what stands before as its
/// category: a key of a row has points of its own, so the message names it.
std::string error(Position at, std::string_view severity, std::string_view message, std::string_view source) {
    return "<error" + xml_attribute("line", std::to_string(at.line)) +
           xml_attribute("column", std::to_string(at.column)) + xml_attribute("severity", severity) +
           xml_attribute("message", message) + xml_attribute("source", source) + "/>\n";
}

std::string message_of(const Finding& finding) {
    return printable(finding.message()) + (finding.row == nullptr ? "" : " [" + code_with_key(finding) + "]");
}

} // namespace

std::string write_checkstyle(const Report& report) {
    const std::string root = source_root();
    std::string out = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<checkstyle version=\"4.3\">\n";
    const auto add_file = [&](const std::string& path, const std::string& errors) {
        out += "  <file" + xml_attribute("name", path) +
               (errors.empty() ? "/>\n" : ">\n" + errors + "  </file>\n");
    };
    for (const Notice* notice : run_errors(report))
        add_file(notice->path.empty() ? "." : service_path(notice->path, root),
                 "    " + error({1, 1}, "error", printable(notice->message), "maclint.run"));
    for (const auto& [source, findings] : findings_by_file(report)) {
        std::string errors;
        for (const Finding* finding : findings)
            errors += "    " + error(source->position(finding->span.begin), severity_of(finding->severity),
                                     message_of(*finding),
                                     "maclint." + category_of(*finding->rule) + "." +
                                         std::string(finding->rule->code));
        add_file(service_path(source->path(), root), errors);
    }
    return out + "</checkstyle>\n";
}

} // namespace maclint::cli
