//! The report as SARIF 2.1.0 (OASIS standard of 27 March 2020); section numbers below are its.
#include "analyzer/source/encoding.hpp"
#include "cli/config/rule_words.hpp"
#include "cli/report/fingerprint.hpp"
#include "cli/report/heading.hpp"
#include "cli/report/remark.hpp"
#include "cli/report/report.hpp"
#include "cli/report/rule_page.hpp"
#include "cli/report/uri.hpp"
#include "cli/text/letters.hpp"
#include "rules/alarms/alarm_uses.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include <nlohmann/json.hpp>

namespace maclint::cli {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view schema = "https://json.schemastore.org/sarif-2.1.0.json";
constexpr std::string_view root_id = "%SRCROOT%";
constexpr Offset longest_snippet = 4096; ///< bytes; a report is no copy of the programs
/// Reports of one repository are kept apart by it; the part behind the slash, of the run, is left to those
/// who upload (3.17.2).
constexpr std::string_view automation_id = "maclint/";

struct NoticeRow {
    NoticeKind kind;
    std::string_view id;
    std::string_view description;
};

constexpr std::array<NoticeRow, 9> notice_rows{{
    {NoticeKind::unreadable, "NOTE001", "A file could not be read or written."},
    {NoticeKind::configuration, "NOTE002", "A configuration file is wrong."},
    {NoticeKind::foreign, "NOTE003", "A file is in a language that maclint does not lint."},
    {NoticeKind::left_out, "NOTE004", "Something was not looked at."},
    {NoticeKind::nothing_checked, "NOTE005", "No program was checked."},
    {NoticeKind::baseline, "NOTE006", "The findings differ from those that are known."},
    {NoticeKind::origin, "NOTE007", "A configuration is of another user, or from above the repository."},
    {NoticeKind::vendor, "NOTE008", "Warnings and notes in programs of a maker do not count."},
    {NoticeKind::idle_setting, "NOTE009", "Something in a configuration has no effect."},
}};

/// "jump-into-loop" as SARIF viewers want names: "JumpIntoLoop".
std::string pascal(std::string_view name) {
    std::string out;
    bool capital = true;
    for (const char c : name) {
        if (c == '-') {
            capital = true;
        } else {
            out += capital ? in_upper_case(std::string_view(&c, 1)) : std::string(1, c);
            capital = false;
        }
    }
    return out;
}

/// Braces mean placeholders in message texts (3.11.5).
std::string without_placeholders(std::string_view text) {
    std::string out;
    for (const char c : text) {
        out += c;
        if (c == '{' || c == '}') out += c;
    }
    return out;
}

/// Text of ours as a sentence with a capital and a full stop.
std::string sentence(std::string_view text) {
    std::string out(text);
    if (!out.empty()) out.front() = in_upper_case(out.substr(0, 1)).front();
    const bool ends = out.ends_with('.') || out.ends_with('?') || out.ends_with('!');
    return ends ? out : out + ".";
}

Json text_message(std::string_view text) { return {{"text", without_placeholders(text)}}; }

std::string_view level_of(Severity severity) { return name_of(severity); }

std::string_view problem_severity(Severity severity) {
    return severity == Severity::note ? "recommendation" : name_of(severity);
}

class SarifWriter {
  public:
    explicit SarifWriter(const Report& report)
        : report_(report) {
        collect_artifacts();
        collect_line_hashes();
    }

    /// Results are put into words one by one: as a tree they would take many times the memory of their text.
    std::string write() {
        constexpr std::string_view no_results = R"("results": [])"; // within a string its quotes were escaped
        constexpr std::size_t depth_of_results = 8;
        const std::string indent(depth_of_results, ' ');
        const std::string frame = text_of(document());
        const std::size_t begin = frame.find(no_results) + no_results.size() - 1; // its closing bracket
        std::string text = frame.substr(0, begin);
        for (const FilteredFinding& filtered : report_.findings) {
            text += text.back() == '[' ? "\n" + indent : ",\n" + indent;
            for (const char c : text_of(result_of(filtered))) {
                text += c;
                if (c == '\n') text += indent;
            }
        }
        if (!report_.findings.empty()) text += "\n" + indent.substr(2);
        return text.append(frame, begin);
    }

  private:
    static std::string text_of(const Json& json) {
        return printable_json(json.dump(2, ' ', false, Json::error_handler_t::replace));
    }

    /// Everything but the results.
    Json document() {
        Json run = {
            {"tool", {{"driver", driver()}}},
            {"automationDetails", {{"id", automation_id}}},
            {"invocations", Json::array({invocation()})},
            {"originalUriBaseIds",
             {{root_id,
               {{"description", text_message("The repository, or the folder in which maclint ran.")}}}}},
            {"artifacts", artifacts()},
            {"results", Json::array()},
            {"columnKind", "utf16CodeUnits"}};
        run["taxonomies"] = taxonomies();
        return {{"$schema", schema}, {"version", "2.1.0"}, {"runs", Json::array({std::move(run)})}};
    }

    // ---- files

    void add_artifact(const Source& source) {
        if (artifact_index_.try_emplace(&source, artifact_files_.size()).second)
            artifact_files_.push_back(&source);
    }

    /// Files that were linted, then those that findings lead to.
    void collect_artifacts() {
        for (const auto& source : report_.files) add_artifact(*source);
        for (const FilteredFinding& filtered : report_.findings) {
            add_artifact(*filtered.finding.source);
            for (const RelatedLocation& related : filtered.finding.related) add_artifact(*related.source);
            for (const RelatedLocation& related : filtered.finding.path) add_artifact(*related.source);
            for (const Fix& fix : filtered.finding.fixes)
                for (const Edit& edit : fix.edits) add_artifact(*edit.source);
        }
    }

    void collect_line_hashes() {
        std::map<const Source*, std::set<std::uint32_t>> wanted;
        for (const FilteredFinding& filtered : report_.findings) {
            const Source& source = *filtered.finding.source;
            wanted[&source].insert(source.position(filtered.finding.span.begin).line);
        }
        for (const auto& [source, lines] : wanted) line_hashes_[source] = line_hashes(*source, lines);
    }

    [[nodiscard]] Json artifacts() const {
        Json list = Json::array();
        for (std::size_t i = 0; i < artifact_files_.size(); ++i) {
            const Source& source = *artifact_files_[i];
            Json artifact = {{"location", location_of_path(source.path())},
                             {"length", source.stored_bytes().size()},
                             {"encoding", registered_name_of(source.stored_encoding())}};
            artifact["location"]["index"] = i;
            if (i < report_.files.size()) artifact["roles"] = {"analysisTarget"};
            list.push_back(std::move(artifact));
        }
        return list;
    }

    [[nodiscard]] Json location_of_path(const std::string& path) const {
        const FileUri uri = uri_of(path, root_);
        Json location = {{"uri", uri.uri}};
        if (uri.below_root) location["uriBaseId"] = root_id;
        return location;
    }

    [[nodiscard]] Json artifact_location(const Source& source) const {
        Json location = location_of_path(source.path());
        location["index"] = artifact_index_.at(&source);
        return location;
    }

    // ---- places

    static Json region_of(const Source& source, Span span) {
        const Position begin = source.position(span.begin);
        const Position end = source.position(span.end);
        return {{"startLine", begin.line},
                {"startColumn", begin.column},
                {"endLine", end.line},
                {"endColumn", end.column}};
    }

    static Json region_with_snippet(const Source& source, Span span) {
        Json region = region_of(source, span);
        if (span.length() <= longest_snippet)
            region["snippet"] = {{"text", source.to_utf8(source.bytes(span))}};
        return region;
    }

    /// The lines around a span: one more on each side, when they are of a sensible length.
    static std::optional<Json> context_of(const Source& source, Span span) {
        const std::uint32_t first = source.position(span.begin).line;
        const std::uint32_t last = source.position(span.end).line;
        const std::uint32_t from = std::max(first, 2U) - 1;
        const std::uint32_t to = std::min(last + 1, source.line_count());
        if (from == first && to == last) return std::nullopt;
        const Span lines{source.line_span(from).begin, source.line_span(to).end};
        if (lines.length() > longest_snippet || !lines.covers(span)) return std::nullopt;
        return Json{{"startLine", from},
                    {"endLine", to},
                    {"snippet", {{"text", source.to_utf8(source.bytes(lines))}}}};
    }

    [[nodiscard]] Json physical(const Source& source, Span span) const {
        Json physical = {{"artifactLocation", artifact_location(source)},
                         {"region", region_with_snippet(source, span)}};
        if (auto context = context_of(source, span)) physical["contextRegion"] = *std::move(context);
        return physical;
    }

    /// A place without a context, for all but the finding's own.
    [[nodiscard]] Json short_physical(const Source& source, Span span) const {
        return {{"artifactLocation", artifact_location(source)},
                {"region", region_with_snippet(source, span)}};
    }

    // ---- results

    Json result_of(const FilteredFinding& filtered) {
        const Finding& finding = filtered.finding;
        Json message = {{"text", without_placeholders(heading_of(*finding.rule) + finding.message())}};
        // With repeats or an alarm the rule's message is not the whole of it (3.11.6).
        if (finding.repeats.empty() && finding.alarm.empty()) {
            message["id"] = finding.message_id;
            if (!finding.arguments.empty()) message["arguments"] = finding.arguments;
        }
        // Of a row the identifier has one component more than that of the descriptor (3.27.5, 3.52.4).
        Json result = {
            {"ruleId", code_with_key(finding)},
            {"ruleIndex", RuleStates::index_of(*finding.rule)},
            {"level", level_of(finding.severity)},
            {"message", std::move(message)},
            {"locations", Json::array({{{"physicalLocation", physical(*finding.source, finding.span)}}})},
            {"partialFingerprints", fingerprints_of(finding)}};
        if (Json related = related_of(finding); !related.empty())
            result["relatedLocations"] = std::move(related);
        if (!finding.path.empty()) result["codeFlows"] = code_flows_of(finding);
        for (const Fix& fix : finding.fixes) result["fixes"].push_back(fix_of(fix));
        result["suppressions"] = suppressions_of(filtered);
        if (report_.has_baseline) result["baselineState"] = is_known(filtered) ? "unchanged" : "new";
        return result;
    }

    Json fingerprints_of(const Finding& finding) {
        const std::uint32_t line = finding.source->position(finding.span.begin).line;
        Json prints = Json::object();
        const auto& hashes = line_hashes_.at(finding.source.get());
        if (const auto hash = hashes.find(line); hash != hashes.end())
            prints["primaryLocationLineHash"] = hash->second;
        prints["maclint/v2"] = fingerprints_.of(finding);
        return prints;
    }

    [[nodiscard]] Json related_of(const Finding& finding) const {
        Json list = Json::array();
        for (const RelatedLocation& related : finding.further_places())
            list.push_back({{"id", list.size() + 1},
                            {"physicalLocation", short_physical(*related.source, related.span)},
                            {"message", text_message(sentence(remark_of(related, Remarks::alone)))}});
        return list;
    }

    [[nodiscard]] Json code_flows_of(const Finding& finding) const {
        Json steps = Json::array();
        for (const RelatedLocation& related : finding.path)
            steps.push_back({{"location",
                              {{"physicalLocation", short_physical(*related.source, related.span)},
                               {"message", text_message(sentence(remark_of(related, Remarks::alone)))}}},
                             {"executionOrder", steps.size() + 1}});
        return Json::array({{{"threadFlows", Json::array({{{"locations", std::move(steps)}}})}}});
    }

    /// Edits are sorted by their file.
    [[nodiscard]] Json fix_of(const Fix& fix) const {
        Json changes = Json::array();
        const Source* in = nullptr;
        for (const Edit& edit : fix.edits) {
            if (edit.source.get() != in)
                changes.push_back(
                    {{"artifactLocation", artifact_location(*edit.source)}, {"replacements", Json::array()}});
            in = edit.source.get();
            changes.back()["replacements"].push_back({{"deletedRegion", region_of(*edit.source, edit.span)},
                                                      {"insertedContent", {{"text", edit.text}}}});
        }
        return {{"description", text_message(sentence(fix.title))},
                {"artifactChanges", std::move(changes)},
                {"properties", {{"applicability", name_of(fix.applicability)}}}};
    }

    /// An empty list says that the finding was looked at and is not suppressed (3.27.23).
    [[nodiscard]] Json suppressions_of(const FilteredFinding& filtered) const {
        if (!filtered.suppressed) return Json::array();
        if (is_withheld(filtered)) return exemptions_as_suppressions(filtered);
        if (is_of_vendor(filtered))
            return Json::array({{{"kind", "external"},
                                 {"status", "accepted"},
                                 {"justification", "a program of its maker: vendor code"}}});
        if (is_known(filtered)) {
            const std::string& path = filtered.suppressed->baseline;
            return Json::array(
                {{{"kind", "external"},
                  {"status", "accepted"},
                  {"justification", "The baseline " + to_utf8(path, detect_encoding(path)) + " knows it."}}});
        }
        Json suppression = {{"kind", "inSource"}, {"status", "accepted"}};
        if (!filtered.suppressed->reason.empty()) suppression["justification"] = filtered.suppressed->reason;
        suppression["location"] = {
            {"physicalLocation", short_physical(*filtered.finding.source, filtered.suppressed->comment)}};
        return Json::array({std::move(suppression)});
    }

    /// One would do: each of them holds it back.
    [[nodiscard]] static Json exemptions_as_suppressions(const FilteredFinding& filtered) {
        Json list = Json::array();
        for (const NamedExemption& exemption : withheld_by(filtered.finding))
            list.push_back({{"kind", "external"},
                            {"status", "accepted"},
                            {"justification", exemption.name() + ": " + std::string(exemption.record().why)},
                            {"properties", {{"exemption", exemption.name()}}}});
        return list;
    }

    // ---- the tool

    [[nodiscard]] Json driver() const {
        Json rules = Json::array();
        for (const Rule* rule : all_rules()) rules.push_back(rule_of(*rule));
        Json notices = Json::array();
        for (const NoticeRow& row : notice_rows)
            notices.push_back({{"id", row.id},
                               {"shortDescription", text_message(row.description)},
                               {"fullDescription", text_message(row.description)},
                               {"help", text_message("The message tells what to do.")}});
        Json driver = {{"name", "maclint"},
                       {"fullName", "maclint, a static analyser for NC programs"},
                       {"version", MACLINT_VERSION},
                       {"semanticVersion", MACLINT_VERSION},
                       {"language", "en"},
                       {"rules", std::move(rules)},
                       {"notifications", std::move(notices)}};
        if (!help_base().empty()) driver["informationUri"] = help_base();
        Json supported = Json::array();
        for (const std::string_view list : alarm_lists) supported.push_back({{"name", taxonomy_name(list)}});
        driver["supportedTaxonomies"] = std::move(supported);
        return driver;
    }

    [[nodiscard]] static Json rule_of(const Rule& rule) {
        Json messages = Json::object();
        for (const Message& message : rule.messages)
            messages[std::string(message.id)] = {{"text", heading_of(rule) + std::string(message.text) +
                                                              (message.cure.empty() ? "" : " ") +
                                                              std::string(message.cure)}};
        Json configuration = {{"level", level_of(rule.severity)}};
        if (!rule.on_by_default) configuration["enabled"] = false;
        Json out = {{"id", rule.code},
                    {"name", pascal(rule.name)},
                    {"shortDescription", text_message(summary_sentence(rule))},
                    {"fullDescription", text_message(summary_sentence(rule) + " " + sentence(rule.why))},
                    {"messageStrings", std::move(messages)},
                    {"defaultConfiguration", std::move(configuration)},
                    {"help", {{"text", plain_page(rule, {}, {})}, {"markdown", markdown_page(rule)}}},
                    {"properties",
                     {{"precision", name_of(rule.precision)},
                      {"problem.severity", problem_severity(rule.severity)},
                      {"tags", {"nc-program", family_of(rule)}}}}};
        for (const RuleExemption& record : rule.exemptions)
            out["properties"]["exemptions"].push_back({{"name", record.name}, {"why", record.why}});
        if (const std::string page = page_url(rule); !page.empty()) out["helpUri"] = page;
        if (Json related = relationships_of(rule); !related.empty())
            out["relationships"] = std::move(related);
        return out;
    }

    /// To the alarms that the rule names itself, and those that its rows do.
    [[nodiscard]] static Json relationships_of(const Rule& rule) {
        Json related = Json::array();
        for (const AlarmName& alarm : alarms_of(rule))
            related.push_back(
                {{"target", {{"id", alarm.number}, {"toolComponent", {{"name", taxonomy_name(alarm.list)}}}}},
                 {"kinds", {"relevant"}}});
        return related;
    }

    // ---- alarms as taxonomies

    [[nodiscard]] static std::string taxonomy_name(std::string_view list) {
        return std::string(list) + " alarms";
    }

    /// All alarms of the lists, also those that no rule finds.
    [[nodiscard]] static Json taxonomies() {
        Json all = Json::array();
        for (const std::string_view list : alarm_lists) {
            Json taxa = Json::array();
            for (const std::span<const ControlAlarm> table : alarm_tables())
                for (const ControlAlarm& alarm : table)
                    if (const std::string_view title = alarm.title_on(list); !title.empty())
                        taxa.push_back({{"id", alarm.number},
                                        {"shortDescription", text_message(sentence(title))},
                                        {"fullDescription", text_message(sentence(alarm.cause))}});
            all.push_back({{"name", taxonomy_name(list)},
                           {"version", MACLINT_VERSION},
                           {"shortDescription",
                            text_message("Alarms that controls of " + std::string(list) + " raise.")},
                           {"taxa", std::move(taxa)}});
        }
        return all;
    }

    // ---- the run

    [[nodiscard]] Json invocation() const {
        Json invocation = {{"executionSuccessful", report_.exit_status != 2},
                           {"exitCode", report_.exit_status}};
        if (report_.times) {
            invocation["startTimeUtc"] = report_.times->begin;
            invocation["endTimeUtc"] = report_.times->end;
        }
        Json execution = Json::array();
        Json configuration = Json::array();
        for (const Notice& notice : report_.notices)
            (notice.kind == NoticeKind::configuration ? configuration : execution)
                .push_back(notification_of(notice));
        if (!execution.empty()) invocation["toolExecutionNotifications"] = std::move(execution);
        if (!configuration.empty()) invocation["toolConfigurationNotifications"] = std::move(configuration);
        return invocation;
    }

    [[nodiscard]] Json notification_of(const Notice& notice) const {
        const auto* const row = std::ranges::find(notice_rows, notice.kind, &NoticeRow::kind);
        Json out = {{"descriptor", {{"id", row->id}, {"index", row - notice_rows.begin()}}},
                    {"level", notice.is_error() ? "error" : "note"},
                    {"message", text_message(sentence(notice.message))}};
        if (!notice.path.empty())
            out["locations"] =
                Json::array({{{"physicalLocation", {{"artifactLocation", location_of_path(notice.path)}}}}});
        return out;
    }

    const Report& report_;
    std::string root_ = source_root();
    std::vector<const Source*> artifact_files_;
    std::map<const Source*, std::size_t> artifact_index_;
    std::map<const Source*, std::map<std::uint32_t, std::string>> line_hashes_;
    Fingerprints fingerprints_;
};

} // namespace

std::string write_sarif(const Report& report) { return SarifWriter(report).write() + "\n"; }

} // namespace maclint::cli
