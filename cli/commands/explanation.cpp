//! Exemptions, variables, alarms and codes are asked first, rules by their names then, and by what they find
//! at last.
#include "cli/commands/explanation.hpp"

#include "cli/config/shop_demands.hpp"
#include "cli/engine/engine.hpp"
#include "cli/report/alarm_page.hpp"
#include "cli/report/code_page.hpp"
#include "cli/report/exemption_page.hpp"
#include "cli/report/group_page.hpp"
#include "cli/report/language_word_page.hpp"
#include "cli/report/row_page.hpp"
#include "cli/report/rule_page.hpp"
#include "cli/report/variable_page.hpp"
#include "rules/words/row_examples.hpp"
#include "rules/words/row_place.hpp"
#include "rules/words/section_pages.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace maclint::cli {
namespace {

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

/// Whether pages of the language are wanted.
bool asks_for(const ExplainRequest& request, const Dialect& dialect) {
    const std::string_view language = find_control(dialect.default_control)->language;
    if (request.control != nullptr && request.control->language != language) return false;
    if (request.dialect != nullptr) return request.dialect == &dialect;
    return language == dialect.name; // else a dialect of another's language
}

/// Of a code of programs, "G860", or of a section, "FACE_C", those that say the same once; none where no
/// chapter has it.
std::vector<ExplainedPage> pages_of_code(const ExplainRequest& request, const PageStyle& style) {
    std::vector<ExplainedPage> pages;
    for (const Dialect& dialect : dialects()) {
        if (!asks_for(request, dialect)) continue;
        const ControlModel& control = *find_control(dialect.default_control);
        const std::string_view language = control.language;
        if (std::string text = plain_group_page(control, request.rule, style); !text.empty())
            pages.push_back({"code", std::move(text)});
        for (const CodePage& page : pages_named(language, request.rule)) {
            if (request.control != nullptr && !page.is_of(*request.control)) continue;
            std::string text = plain_code_page(page, request.control, style);
            if (std::ranges::find(pages, text, &ExplainedPage::text) == pages.end())
                pages.push_back({"code", std::move(text)});
        }
    }
    return pages;
}

/// Of a word of a language, "ATAN", "CYCLE83"; none where it is none of any.
std::vector<ExplainedPage> pages_of_language_word(const ExplainRequest& request, const PageStyle& style) {
    std::vector<ExplainedPage> pages;
    for (const Dialect& dialect : dialects())
        if (asks_for(request, dialect))
            if (std::string text = plain_language_word_page(dialect, request.rule, style); !text.empty())
                pages.push_back({"word", std::move(text)});
    return pages;
}

/// Of an alarm by its number, "128", "PS0078"; none where no list has it.
std::vector<ExplainedPage> pages_of_alarm(const ExplainRequest& request, const PageStyle& style) {
    if (request.dialect != nullptr) return {};
    const std::string_view list = request.control == nullptr ? std::string_view() : request.control->alarms;
    if (request.control != nullptr && list.empty()) return {};
    std::vector<ExplainedPage> pages;
    for (const ControlAlarm* alarm : alarms_named(request.rule, list))
        pages.push_back({"alarm", plain_alarm_page(*alarm, list, style)});
    return pages;
}

ExplainedPage page_of(const NamedRule& named, const PageStyle& style) {
    if (named.row == nullptr) return {"rule", page_of(*named.rule, style), named};
    return {"row", page_of(*named.row, style), named};
}

/// Whether the control, or one of the language, that is asked for has what the rule or row speaks of.
bool is_there(const ExplainRequest& request, const NamedRule& one) {
    const auto has_it = [&](const ControlModel& control) {
        if (one.row == nullptr) return applies_to(*one.rule, control);
        return std::ranges::any_of(one.row->rows, [&](const RowForCode& row) { return is_of(row, control); });
    };
    if (request.control != nullptr) return has_it(*request.control);
    if (request.dialect == nullptr) return true;
    const std::string_view language = find_control(request.dialect->default_control)->language;
    return std::ranges::any_of(controls(), [&](const ControlModel* control) {
        return control->language == language && has_it(*control);
    });
}

/// What the word may mean on the controls that are asked for.
std::vector<NamedRule> named_by(const ExplainRequest& request) {
    std::vector<NamedRule> named = rules_meant(request.rule);
    if (request.control == nullptr && request.dialect == nullptr) return named;
    std::erase_if(named, [&](const NamedRule& one) { return !is_there(request, one); });
    return named;
}

/// Rules that find what the words are about, beside those that are known.
void add_rules_about(const ExplainRequest& request, std::vector<NamedRule>& named) {
    for (const NamedRule& about : rules_about(request.rule)) {
        const bool is_known = std::ranges::find(named, about) != named.end();
        if (!is_known && is_there(request, about)) named.push_back(about);
    }
}

} // namespace

Explanation explanation_of(const ExplainRequest& request, const PageStyle& style) {
    if (const auto exemption = find_exemption(request.rule))
        return {{{"exemption", plain_exemption_page(*exemption, style)}}, {}};
    if (const auto number = variable_number_in(request.rule)) {
        std::string pages = plain_variable_pages(*number, request.control, style);
        if (!pages.empty()) return {{{"variable", std::move(pages)}}, {}};
    }
    auto named = named_by(request);
    if (auto pages = pages_of_alarm(request, style); !pages.empty())
        return {std::move(pages), std::move(named)};
    if (auto pages = pages_of_code(request, style); !pages.empty()) return {std::move(pages), {}};
    if (auto pages = pages_of_language_word(request, style); !pages.empty())
        return {std::move(pages), std::move(named)};
    if (named.size() != 1) add_rules_about(request, named);
    if (named.size() == 1) return {{page_of(named.front(), style)}, {}};
    return {{}, std::move(named)};
}

} // namespace maclint::cli
