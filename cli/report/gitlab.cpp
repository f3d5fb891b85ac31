//! GitLab's code quality report: a list of issues as Code Climate has them. GitLab reads description,
//! check_name, fingerprint, severity and location; of two issues with one fingerprint it drops one.
#include "analyzer/source/encoding.hpp"
#include "cli/config/rule_words.hpp"
#include "cli/report/fingerprint.hpp"
#include "cli/report/service.hpp"
#include "cli/report/uri.hpp"

#include <nlohmann/json.hpp>

namespace maclint::cli {
namespace {

using Json = nlohmann::ordered_json;

std::string_view quality_of(Severity severity) {
    switch (severity) {
    case Severity::error: return "critical";
    case Severity::warning: return "major";
    case Severity::note: return "info";
    }
    return {};
}

class GitlabWriter {
  public:
    explicit GitlabWriter(PathDetail detail)
        : detail_(detail) {}

    void add(const Finding& finding) {
        const Position begin = finding.source->position(finding.span.begin);
        const Position end = finding.source->position(finding.span.end);
        const std::string path = service_path(finding.source->path(), root_);
        Json issue = issue_of(path, quality_of(finding.severity), printable(finding.message()));
        issue["check_name"] = code_with_key(finding);
        issue["fingerprint"] = hash_of(name_of(*finding.source)) + "-" + fingerprints_.of(finding);
        issue["location"]["lines"] = {{"begin", begin.line}, {"end", end.line}};
        std::string body;
        for (const std::string& step : steps_of(finding, detail_, root_)) body += "- " + step + "\n";
        if (!body.empty()) issue["content"] = {{"body", body}};
        add(issue);
    }

    void add(const Notice& notice) {
        const std::string path = notice.path.empty() ? "." : service_path(notice.path, root_);
        Json issue = issue_of(path, "blocker", printable(notice.message));
        issue["check_name"] = "maclint";
        issue["fingerprint"] = hash_of(path + "\n" + notice.message);
        issue["location"]["lines"] = {{"begin", 1}};
        add(issue);
    }

    [[nodiscard]] std::string take() { return "[" + out_ + (out_.empty() ? "" : "\n") + "]\n"; }

  private:
    /// The path as it is: two that are shown alike, one of them escaped, are two.
    [[nodiscard]] std::string name_of(const Source& source) const {
        const std::string path = placed_path(source.path(), root_).path;
        return to_utf8(path, detect_encoding(path));
    }

    static Json issue_of(const std::string& path, std::string_view severity, const std::string& message) {
        return {{"type", "issue"},
                {"check_name", ""},
                {"description", message},
                {"categories", {"Bug Risk"}},
                {"severity", severity},
                {"fingerprint", ""},
                {"location", {{"path", path}}}};
    }

    void add(const Json& issue) {
        out_ += out_.empty() ? "\n  " : ",\n  ";
        out_ += printable_json(issue.dump(-1, ' ', false, Json::error_handler_t::replace));
    }

    PathDetail detail_;
    std::string root_ = source_root();
    Fingerprints fingerprints_;
    std::string out_;
};

} // namespace

std::string write_gitlab(const Report& report, const TextStyle& style) {
    GitlabWriter writer(style.path);
    for (const Notice* notice : run_errors(report)) writer.add(*notice);
    for (const auto& [finding, suppressed] : report.findings)
        if (!suppressed) writer.add(finding);
    return writer.take();
}

} // namespace maclint::cli
