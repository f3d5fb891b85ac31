//! `maclint explain RULE`: a rule's page, or the rules that a word may mean.
#include "cli/commands/commands.hpp"
#include "cli/config/selection.hpp"
#include "cli/engine/engine.hpp"
#include "cli/report/rule_page.hpp"
#include "cli/suggest.hpp"
#include "cli/terminal.hpp"

namespace maclint::cli {
namespace {

/// The lines of a bad example at which the rule has its findings.
std::vector<std::uint32_t> lines_found(const Rule& rule, const Example& example) {
    Overrides overrides;
    overrides.isolated = true;
    overrides.dialect = find_dialect(example.dialect);
    overrides.select = {std::string(rule.code)};
    overrides.complete = example.complete;
    Settings settings(std::move(overrides));
    const std::string path = "example.nc";
    Snapshot snapshot;
    snapshot.files.push_back({{.path = path, .named = true},
                              *settings.for_file(path),
                              Source::from_bytes(path, std::string(example.text))});
    Progress progress(Progress::Shown::never);
    std::vector<std::uint32_t> lines;
    for (const auto& [finding, suppressed] : Engine({}, progress).analyse(snapshot).findings)
        lines.push_back(finding.source->position(finding.span.begin).line);
    return lines;
}

std::string page_of(const Rule& rule, ColourChoice colour) {
    MarkedLines marked;
    for (const Example& example : rule.bad) marked.push_back(lines_found(rule, example));
    return plain_page(rule, {colour_for_output(colour), output_width()}, marked);
}

} // namespace

int run_explain(const ExplainRequest& request) {
    const auto rules = rules_meant(request.rule);
    if (rules.size() == 1) return print_text(page_of(*rules.front(), request.colour));
    if (!rules.empty())
        return print_text(plain_list(rules) + "\n" + counted(rules.size(), "rule") + " may be meant by '" +
                          shown(request.rule) + "'.\n");
    print_error("there is no rule '" + shown(request.rule) + "'." +
                did_you_mean(request.rule, rule_words(), "See 'maclint rules' for the list."));
    return exit_error;
}

} // namespace maclint::cli
