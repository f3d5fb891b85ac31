//! The words are those of the reports.
#include "cli/lsp/diagnostics/diagnostic.hpp"

#include "cli/config/rule_words.hpp"
#include "cli/report/rule_page.hpp"
#include "rules/rule.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace maclint::cli::lsp {
namespace {

/// DiagnosticSeverity and DiagnosticTag of LSP.
int severity_number(Severity severity) {
    constexpr int error = 1, warning = 2, information = 3;
    return severity == Severity::error ? error : severity == Severity::warning ? warning : information;
}
constexpr int unnecessary = 1;

/// Rules whose findings are text that does nothing: editors draw it paler.
constexpr std::array<std::string_view, 4> rules_of_idle_text{"unreachable-code", "unreached-text",
                                                             "dead-store", "unused-suppression"};

Json fixes_of(const Finding& finding) {
    Json list = Json::array();
    for (const Fix& fix : finding.fixes)
        list.push_back({{"title", fix.title}, {"applicability", std::string(name_of(fix.applicability))}});
    return list;
}

} // namespace

const LineTable& DiagnosticWriter::lines_of(const std::shared_ptr<const Source>& source) {
    auto& [held, table] = lines_[source.get()];
    if (table == nullptr) {
        held = source;
        table = std::make_unique<LineTable>(*source, encoding_);
    }
    return *table;
}

Json DiagnosticWriter::location(const std::shared_ptr<const Source>& source, Span span) {
    return {{"uri", uri_of_(source->path())}, {"range", lines_of(source).range(span)}};
}

/// The last step is the finding's own place.
Json DiagnosticWriter::related(const Finding& finding) {
    Json list = Json::array();
    const auto add = [&](const RelatedLocation& place) {
        list.push_back({{"location", location(place.source, place.span)}, {"message", place.text}});
    };
    for (const RelatedLocation& place : finding.further_places()) add(place);
    for (const RelatedLocation& step : finding.path) add(step);
    return list;
}

Json DiagnosticWriter::write(const Finding& finding) {
    Json json = {{"range", lines_of(finding.source).range(finding.span)},
                 {"severity", severity_number(finding.severity)},
                 {"code", code_with_key(finding)},
                 {"source", "maclint"},
                 {"message", finding.message()},
                 {"data", {{"name", name_with_key(finding)}, {"fixes", fixes_of(finding)}}}};
    if (const std::string url = page_url(*finding.rule); !url.empty())
        json["codeDescription"] = {{"href", url}};
    if (Json places = related(finding); !places.empty()) json["relatedInformation"] = std::move(places);
    if (std::ranges::find(rules_of_idle_text, finding.rule->name) != rules_of_idle_text.end())
        json["tags"] = {unnecessary};
    return json;
}

} // namespace maclint::cli::lsp
