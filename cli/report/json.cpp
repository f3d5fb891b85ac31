//! The report as JSON of our own; docs/json.md describes it. Keys are added, never changed, within a version.
#include "analyzer/dialect/dialect.hpp"
#include "analyzer/source/encoding.hpp"
#include "cli/report/fingerprint.hpp"
#include "cli/report/remark.hpp"
#include "cli/report/report.hpp"
#include "cli/report/rule_page.hpp"
#include "cli/report/statistics.hpp"
#include "rules/words/rule_row.hpp"

#include <nlohmann/json.hpp>

namespace maclint::cli {
namespace {

using Json = nlohmann::ordered_json;

constexpr int format_version = 1;

Json json_of(const Position& at) { return {{"line", at.line}, {"column", at.column}}; }

Json json_of(const Source& source, Span span) {
    return {{"start", json_of(source.position(span.begin))},
            {"end", json_of(source.position(span.end))},
            {"bytes", {span.begin, span.end}}};
}

std::string utf8(const std::string& path) { return to_utf8(path, detect_encoding(path)); }

std::string path_of(const Source& source) { return utf8(source.path()); }

Json json_of(const std::vector<RelatedLocation>& locations) {
    Json list = Json::array();
    for (const RelatedLocation& related : locations)
        list.push_back({{"file", path_of(*related.source)},
                        {"range", json_of(*related.source, related.span)},
                        {"text", remark_of(related, Remarks::alone)}});
    return list;
}

Json json_of(const std::vector<Edit>& edits) {
    Json list = Json::array();
    for (const Edit& edit : edits)
        list.push_back({{"file", path_of(*edit.source)},
                        {"range", json_of(*edit.source, edit.span)},
                        {"text", edit.text}});
    return list;
}

Json json_of(const FilteredFinding& filtered, const Report& report, Fingerprints& fingerprints) {
    const Finding& finding = filtered.finding;
    const Source& source = *finding.source;
    Json out = {{"code", finding.rule->code}, {"name", finding.rule->name}};
    if (finding.row != nullptr) out["row"] = finding.row->key;
    const Json rest = {{"severity", name_of(finding.severity)},
                       {"message", finding.message()},
                       {"message_id", finding.message_id},
                       {"arguments", finding.arguments},
                       {"file", path_of(source)},
                       {"range", json_of(source, finding.span)},
                       {"related", json_of(finding.further_places())},
                       {"path", json_of(finding.path)},
                       {"fix", finding.fixes.empty() ? Json::array() : json_of(finding.fixes.front().edits)}};
    out.update(rest);
    if (const std::string cure = finding.cure(); !cure.empty()) out["cure"] = cure;
    if (!finding.alarm.empty()) out["alarm"] = finding.alarm;
    out["fingerprint"] = fingerprints.of(finding);
    if (const auto read_as = report.read_as.find(&source); read_as != report.read_as.end()) {
        out["dialect"] = read_as->second.dialect;
        out["control"] = read_as->second.control;
    }
    if (const std::string page = page_url(*finding.rule); !page.empty()) out["url"] = page;
    if (!finding.fixes.empty()) {
        out["fix_title"] = finding.fixes.front().title;
        out["fix_applicability"] = name_of(finding.fixes.front().applicability);
    }
    for (const Fix& other : std::span(finding.fixes).subspan(finding.fixes.empty() ? 0 : 1))
        out["other_fixes"].push_back({{"title", other.title},
                                      {"applicability", name_of(other.applicability)},
                                      {"edits", json_of(other.edits)}});
    if (is_withheld(filtered)) out["exemptions"] = exemptions_of(filtered);
    if (is_withheld(filtered) || is_of_vendor(filtered)) return out;
    if (is_known(filtered))
        out["baseline"] = utf8(filtered.suppressed->baseline);
    else if (filtered.suppressed)
        out["suppressed"] = {{"range", json_of(source, filtered.suppressed->comment)},
                             {"reason", filtered.suppressed->reason}};
    return out;
}

Json json_of(const Statistics& statistics) {
    Json rules = Json::array();
    for (const auto& [rule, row, severity, findings] : statistics.rules) {
        Json count = {{"code", rule->code}, {"name", rule->name}};
        if (row != nullptr) count["row"] = row->key;
        count["severity"] = name_of(severity);
        count["findings"] = findings;
        rules.push_back(std::move(count));
    }
    Json files = Json::array();
    for (const auto& [source, findings] : statistics.files)
        files.push_back({{"file", path_of(*source)}, {"findings", findings}});
    return {{"rules", std::move(rules)}, {"files", std::move(files)}};
}

} // namespace

std::string write_json(const Report& report) {
    Json findings = Json::array();
    Json suppressed = Json::array();
    Json known = Json::array();
    Json vendor = Json::array();
    Json withheld = Json::array();
    Fingerprints fingerprints;
    for (const FilteredFinding& filtered : report.findings)
        (is_withheld(filtered)    ? withheld
         : is_of_vendor(filtered) ? vendor
         : is_known(filtered)     ? known
         : filtered.suppressed    ? suppressed
                                  : findings)
            .push_back(json_of(filtered, report, fingerprints));
    Json notices = Json::array();
    for (const Notice& notice : report.notices)
        notices.push_back({{"severity", notice.is_error() ? "error" : "note"},
                           {"file", utf8(notice.path)},
                           {"message", notice.message}});
    const Tally counts = tally(report);
    Json out = {{"version", format_version},
                {"tool", {{"name", "maclint"}, {"version", MACLINT_VERSION}}},
                {"findings", std::move(findings)},
                {"suppressed", std::move(suppressed)},
                {"known", std::move(known)},
                {"vendor", std::move(vendor)},
                {"notices", std::move(notices)},
                {"summary",
                 {{"files", report.files.size()},
                  {"errors", counts.errors},
                  {"warnings", counts.warnings},
                  {"notes", counts.notes},
                  {"suppressed", counts.suppressed},
                  {"known", counts.known},
                  {"vendor", counts.vendor},
                  {"not_shown", report.not_shown.size()},
                  {"passed_over",
                   {{"other_names", report.passed_over.other_names},
                    {"ignored_by_git", report.passed_over.ignored_by_git},
                    {"links_out", report.passed_over.links_out}}},
                  {"exit_status", report.exit_status}}}};
    if (report.withheld == Withheld::listed) {
        out["withheld"] = std::move(withheld);
        out["summary"]["withheld"] = counts.withheld;
    }
    if (report.statistics) out["statistics"] = json_of(statistics_of(report));
    if (report.times) out["times"] = {{"begin", report.times->begin}, {"end", report.times->end}};
    return printable_json(out.dump(2, ' ', false, Json::error_handler_t::replace)) + "\n";
}

} // namespace maclint::cli
