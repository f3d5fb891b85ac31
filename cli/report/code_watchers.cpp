//! Looks rows and rules through for a code.
#include "cli/report/code_watchers.hpp"

#include "analyzer/dialect/dialect.hpp"
#include "cli/report/mentions.hpp"
#include "cli/text/letters.hpp"
#include "rules/words/row_place.hpp"
#include "rules/words/row_text.hpp"
#include "rules/words/section_pages.hpp"
#include "rules/words/word_list.hpp"

#include <algorithm>

namespace maclint::cli {
namespace {

/// Whether the row holds for the code of the page on one of these controls, in one of its sections, or where
/// it has no place.
bool is_of(const CodePage& page, const RowForCode& row, const std::vector<const ControlModel*>& on) {
    if (row.table->language != page.book->language || !has_word(page.head->row.code, code_of(row)))
        return false;
    if (std::ranges::none_of(on, [&](const ControlModel* control) { return maclint::is_of(row, *control); }))
        return false;
    const std::string_view sections = row.row->sections.empty() ? row.table->sections : row.row->sections;
    return row.row->says == RowStatement::refused || sections.empty() ||
           (!page.sections().empty() && has_word(sections, words_of(page.sections()).front()));
}

/// " (alarm 045 on FANUC 30i/0i-D)", with the controls where the row holds on some of the page's alone.
std::string additions_of(const RowForCode& row, const std::vector<const ControlModel*>& on) {
    std::vector<std::string> additions;
    for (const RowAlarm& alarm : row.row->alarms)
        if (!alarm.number.empty() && std::ranges::any_of(on, [&](const ControlModel* control) {
                return control->alarms == alarm.control;
            }))
            additions.push_back("alarm " + std::string(alarm.number) + " on " + std::string(alarm.control));
    const std::string where = narrowed_to(*row.row);
    if (!where.empty() &&
        std::ranges::any_of(on, [&](const ControlModel* control) { return !maclint::is_of(row, *control); }))
        additions.push_back("only on " + where);
    std::string text;
    for (const std::string& addition : additions) text += (text.empty() ? " (" : "; ") + addition;
    return text.empty() ? text : text + ")";
}

} // namespace

std::vector<const ControlModel*> controls_of(const CodePage& page, const ControlModel* only) {
    std::vector<const ControlModel*> found;
    for (const ControlModel* control : controls())
        if ((only == nullptr || only == control) && page.is_of(*control)) found.push_back(control);
    return found;
}

bool is_section(const CodePage& page) {
    const auto books = all_section_books();
    return std::ranges::find(books, page.book) != books.end();
}

std::vector<RowOfPage> rows_watching(const CodePage& page, const ControlModel* only) {
    const auto on = controls_of(page, only);
    std::vector<RowOfPage> rows;
    for (const RuleRow& rule_row : all_rule_rows())
        for (const RowForCode& row : rule_row.rows)
            if (is_of(page, row, on)) rows.push_back({&rule_row, sentence_of(row) + additions_of(row, on)});
    return rows;
}

std::vector<const Rule*> rules_watching(const CodePage& page, const ControlModel* only) {
    if (is_section(page)) return {find_rule("DIN109")};
    std::vector<const Rule*> rules;
    const auto on = controls_of(page, only);
    for (const Rule* rule : all_rules()) {
        const auto speaks = [&](std::string_view code) {
            return mentions_code(rule->summary, code) || mentions_code(rule->why, code) ||
                   mentions_code(in_upper_case(rule->name), code) ||
                   std::ranges::any_of(rule->messages, [&](const Message& message) {
                       return mentions_code(message.text, code) || mentions_code(message.cure, code);
                   });
        };
        if (std::ranges::any_of(words_of(page.head->row.code), speaks) &&
            std::ranges::any_of(on, [&](const ControlModel* control) { return applies_to(*rule, *control); }))
            rules.push_back(rule);
    }
    return rules;
}

std::string systems_in_words(std::string_view systems) {
    std::string list;
    for (const char system : systems) list.append(list.empty() ? "" : " ").push_back(system);
    return "system " + either_of(list);
}

std::string narrowed_to(const WordRow& row) {
    std::string where = either_of(row.controls);
    if (!row.systems.empty()) where += (where.empty() ? "" : ", ") + systems_in_words(row.systems);
    return where;
}

} // namespace maclint::cli
