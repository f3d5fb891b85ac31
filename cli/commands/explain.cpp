//! `maclint explain RULE`: the page of a rule or a row, of a code, a variable or an alarm, or all that a word
//! may mean.
#include "cli/commands/commands.hpp"
#include "cli/config/rule_words.hpp"
#include "cli/config/shop_demands.hpp"
#include "cli/engine/engine.hpp"
#include "cli/report/alarm_page.hpp"
#include "cli/report/code_page.hpp"
#include "cli/report/exemption_page.hpp"
#include "cli/report/row_page.hpp"
#include "cli/report/rule_page.hpp"
#include "cli/report/variable_page.hpp"
#include "cli/suggest.hpp"
#include "cli/terminal.hpp"
#include "rules/listed.hpp"
#include "rules/words/row_examples.hpp"
#include "rules/words/row_place.hpp"
#include "rules/words/section_pages.hpp"

#include <algorithm>
#include <vector>

namespace maclint::cli {
namespace {

/// With an empty line between them.
std::string joined(const std::vector<std::string>& pages) {
    std::string text;
    for (const std::string& page : pages) text += (text.empty() ? "" : "\n") + page;
    return text;
}

/// The lines of a bad example at which what is selected has its findings.
std::vector<std::uint32_t> lines_found(const Example& example, Overrides overrides) {
    overrides.isolated = true;
    overrides.dialect = find_dialect(example.dialect);
    overrides.complete = example.complete;
    if (!example.control.empty()) overrides.machine = facts_of_example(example.control);
    Settings settings(std::move(overrides));
    const std::string path(example.file);
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

std::string page_of(const Rule& rule, const PageStyle& style) {
    Overrides overrides;
    overrides.select = {std::string(rule.code)};
    MarkedLines marked;
    for (const Example& example : rule.bad) marked.push_back(lines_found(example, overrides));
    return plain_page(rule, style, marked) + plain_rows(rule, style);
}

std::string page_of(const RuleRow& row, const PageStyle& style) {
    Overrides overrides;
    overrides.select = {row.name()};
    MarkedRows marked;
    for (const RowForCode& entry : row.rows) {
        const RowExamples examples = examples_of(entry);
        overrides.control = examples.control;
        marked.push_back(lines_found(Example(examples.dialect, examples.bad), overrides));
    }
    return plain_row_page(row, style, marked);
}

/// The rules, or the rows, that a word may mean.
std::string list_of(const std::vector<NamedRule>& named) {
    std::vector<const Rule*> rules;
    std::vector<const RuleRow*> rows;
    for (const auto& [rule, row] : named) {
        if (row == nullptr)
            rules.push_back(rule);
        else
            rows.push_back(row);
    }
    std::vector<std::string> counts;
    if (!rules.empty()) counts.push_back(counted(rules.size(), "rule"));
    if (!rows.empty()) counts.push_back(counted(rows.size(), "row"));
    const std::string heading = rules.empty() || rows.empty() ? "" : "\nrows\n";
    return plain_list(rules, ListedRows::left_out) + heading + list_of_rows(rows) + "\n" +
           rules::listed(counts, " and ");
}

/// Whether pages of the language are wanted.
bool asks_for(const ExplainRequest& request, const Dialect& dialect) {
    const std::string_view language = find_control(dialect.default_control)->language;
    if (request.control != nullptr && request.control->language != language) return false;
    if (request.dialect != nullptr) return request.dialect == &dialect;
    return language == dialect.name; // else a dialect of another's language
}

/// The pages of a code of programs, "G860", or of a section, "FACE_C", those that say the same once; empty
/// where no chapter has it.
std::string pages_of(const ExplainRequest& request, const PageStyle& style) {
    std::vector<std::string> pages;
    for (const Dialect& dialect : dialects()) {
        if (!asks_for(request, dialect)) continue;
        const std::string_view language = find_control(dialect.default_control)->language;
        for (const CodePage& page : pages_named(language, request.rule)) {
            if (request.control != nullptr && !page.is_of(*request.control)) continue;
            std::string text = plain_code_page(page, request.control, style);
            if (std::ranges::find(pages, text) == pages.end()) pages.push_back(std::move(text));
        }
    }
    return joined(pages);
}

/// The pages of an alarm by its number, "128", "PS0078"; empty where no list has it.
std::string pages_of_alarm(const ExplainRequest& request, const PageStyle& style) {
    if (request.dialect != nullptr) return {};
    std::vector<std::string> pages;
    const std::string_view list = request.control == nullptr ? std::string_view() : request.control->alarms;
    if (request.control != nullptr && list.empty()) return {};
    for (const ControlAlarm* alarm : alarms_named(request.rule, list))
        pages.push_back(plain_alarm_page(*alarm, list, style));
    return joined(pages);
}

/// What the word may mean on the control, where one is asked for.
std::vector<NamedRule> named_by(const ExplainRequest& request) {
    std::vector<NamedRule> named = rules_meant(request.rule);
    if (request.control != nullptr)
        std::erase_if(named, [&](const NamedRule& one) {
            const auto is_on = [&](const RowForCode& row) { return is_of(row, *request.control); };
            return one.row == nullptr ? !applies_to(*one.rule, *request.control)
                                      : std::ranges::none_of(one.row->rows, is_on);
        });
    return named;
}

} // namespace

int run_explain(const ExplainRequest& request) {
    const PageStyle style{colour_for_output(request.colour), output_width()};
    if (const auto exemption = find_exemption(request.rule))
        return print_text(plain_exemption_page(*exemption, style));
    if (const auto number = variable_number_in(request.rule)) {
        const std::string pages = plain_variable_pages(*number, request.control, style);
        if (!pages.empty()) return print_text(pages);
    }
    const auto named = named_by(request);
    if (const std::string pages = pages_of_alarm(request, style); !pages.empty())
        return print_text(pages +
                          (named.empty() ? "" : "\nRules with that number:\n" + list_of(named) + ".\n"));
    if (const std::string pages = pages_of(request, style); !pages.empty()) return print_text(pages);
    if (named.size() == 1) {
        const auto& [rule, row] = named.front();
        return print_text(row == nullptr ? page_of(*rule, style) : page_of(*row, style));
    }
    if (!named.empty())
        return print_text(list_of(named) + " may be meant by '" + shown(request.rule) + "'.\n");
    print_error(
        "there is no rule" +
        std::string(request.control == nullptr ? "" : ", and no such code or alarm of that control,") + " '" +
        shown(request.rule) + "'." + advice_for(request.rule));
    return exit_error;
}

} // namespace maclint::cli
