//! A whole run over one file or two, and what comes of it in every format.
#include "analyzer/dialect/dialect.hpp"
#include "cli/commands/report_target.hpp"
#include "cli/input/report_lines.hpp"
#include "cli/report/report.hpp"
#include "fuzz/harness.hpp"
#include "tests/support/folder.hpp"
#include "tests/support/linted.hpp"

#include <algorithm>
#include <array>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

using namespace maclint;

namespace {

/// Divides an input into two files.
constexpr std::string_view mark = "\n~~~~\n";

std::vector<test::LintedText> texts_of(std::string_view text) {
    const std::size_t at = text.find(mark);
    std::vector<test::LintedText> texts = {{"a/O1.nc", std::string(text.substr(0, at))}};
    if (at != std::string_view::npos)
        texts.push_back({"a/O2.ncs", std::string(text.substr(at + mark.size()))});
    return texts;
}

void require_inside(const Source* source, Span span) {
    fuzz::require(source != nullptr, "a finding without a file");
    fuzz::require(span.begin <= span.end && span.end <= source->size(), "a finding outside its file");
}

/// {0} and the like are filled in, unless the program itself holds them.
void require_filled(const Finding& finding) {
    const std::string message = finding.message();
    fuzz::require(!message.empty(), "a finding without a message");
    for (const char* hole : {"{0}", "{1}", "{2}", "{3}", "{4}"})
        fuzz::require(message.find(hole) == std::string::npos ||
                          std::ranges::any_of(finding.arguments,
                                              [&](const std::string& argument) {
                                                  return argument.find(hole) != std::string::npos;
                                              }),
                      "a message with an empty place");
}

void check(const Finding& finding) {
    require_inside(finding.source.get(), finding.span);
    for (const RelatedLocation& place : finding.further_places())
        require_inside(place.source.get(), place.span);
    for (const RelatedLocation& place : finding.path) require_inside(place.source.get(), place.span);
    for (const Fix& fix : finding.fixes)
        for (const Edit& edit : fix.edits) require_inside(edit.source.get(), edit.span);
    require_filled(finding);
}

void require_json(const std::string& text, const std::string& name) {
    fuzz::require_harmless(text, name);
    if (!nlohmann::json::accept(text)) fuzz::fail(name + " is no JSON");
}

/// A text that is wrapped where a `%` stands in it, or quotes blocks, may be taken for a program: a control
/// begins to read there.
bool quotes_blocks(const std::string& report) {
    std::istringstream lines(report);
    for (std::string line; std::getline(lines, line);)
        if (line.find('|') == std::string::npos && cli::is_like_blocks(line)) return true;
    return false;
}

/// A report must not be taken for a program, or the next run could not write it again.
void require_writable_again(const std::string& report) {
    if (quotes_blocks(report)) return;
    static const test::TemporaryFolder folder;
    const std::string path = folder.write("report", report);
    const cli::Settings settings(cli::Overrides{});
    cli::CheckRequest request;
    request.sinks = {{cli::Format::text, path}};
    fuzz::require(!cli::refuse_targets(request, {}, settings), "a report is taken for a program");
}

/// Reports for build services: a command a line, JSON, XML that no text opens an element in.
void check_services(const cli::Report& report) {
    const std::string github = write_github(report, {.summary = cli::Summary::left_out});
    fuzz::require_harmless(github, "the GitHub report");
    const auto shown =
        std::ranges::count_if(report.findings, [](const auto& each) { return !each.suppressed; });
    const auto errors = std::ranges::count_if(report.notices, &cli::Notice::is_error);
    fuzz::require(std::ranges::count(github, '\n') == shown + errors, "a GitHub command of several lines");
    require_json(write_gitlab(report, {}), "the GitLab report");
    for (const std::string& xml : {write_junit(report, {}), write_checkstyle(report)}) {
        fuzz::require_harmless(xml, "an XML report");
        fuzz::require(std::ranges::count(xml, '<') == std::ranges::count(xml, '>'), "a broken element");
    }
}

} // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text = fuzz::text_of(data, size);
    cli::Overrides overrides;
    constexpr std::array<const char*, 6> names = {"auto", "auto", "fanuc", "nct", "dinplus", "dinplus"};
    overrides.dialect = find_dialect(names[fuzz::choice(text, names.size())]);
    overrides.complete = fuzz::choice(text, 14) < 7;
    cli::Result result = test::lint_texts(texts_of(text), std::move(overrides));
    cli::Report report;
    report.findings = std::move(result.findings);
    report.notices = std::move(result.notices);
    report.files = std::move(result.sources);
    for (const cli::FilteredFinding& filtered : report.findings) check(filtered.finding);
    for (const std::size_t width : {cli::usual_width, std::size_t{40}}) {
        const std::string people = write_text(report, {.path = cli::PathDetail::full, .width = width});
        fuzz::require_harmless(people, "the text report");
        if (fuzz::choice(text, 8) == 0) require_writable_again(people);
    }
    const std::string concise = write_concise(report, {});
    fuzz::require_harmless(concise, "the concise report");
    if (fuzz::choice(text, 8) == 1) require_writable_again(concise);
    if (fuzz::choice(text, 3) == 0) require_json(write_json(report), "the JSON report");
    if (fuzz::choice(text, 11) == 0) require_json(write_sarif(report), "the SARIF report");
    if (fuzz::choice(text, 3) == 1) check_services(report);
    return 0;
}
