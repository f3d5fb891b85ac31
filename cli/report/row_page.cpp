//! Made from the tables of words, so that pages cannot say anything else.
#include "cli/report/row_page.hpp"

#include "analyzer/dialect/dialect.hpp"
#include "cli/config/selection.hpp"
#include "cli/report/rule_page.hpp"
#include "rules/alarms/alarm.hpp"
#include "rules/words/row_examples.hpp"
#include "rules/words/word_list.hpp"

#include <algorithm>

namespace maclint::cli {
namespace {

std::string without_full_stop(std::string_view text) {
    return std::string(text.substr(0, text.size() - (text.ends_with('.') ? 1 : 0)));
}

/// "on", "off: others write so, too".
std::string default_of(const RuleRow& row) {
    if (row.on_by_default()) return "on";
    const std::string_view why = row.first().off_reason;
    return why.empty() ? "off" : "off: " + without_full_stop(why);
}

/// "DIN624, DIN625", of all entries of the row.
std::string aliases_of(const RuleRow& row) {
    std::vector<std::string_view> aliases;
    for (const RowForCode& entry : row.rows)
        for (const std::string_view alias : words_of(entry.row->aliases))
            if (std::ranges::find(aliases, alias) == aliases.end()) aliases.push_back(alias);
    std::string list;
    for (const std::string_view alias : aliases) list.append(list.empty() ? "" : ", ").append(alias);
    return list;
}

std::string facts_of(const RuleRow& row, const WordRow& entry) {
    std::string facts = "Severity: " + std::string(name_of(entry.severity)) + ". ";
    facts += row.on_by_default() ? "On by default." : "Off by default.";
    if (!row.on_by_default() && !row.first().off_reason.empty())
        facts += " " + without_full_stop(row.first().off_reason) + ".";
    if (!entry.aliases.empty()) facts += " Also known as " + aliases_of(row) + ".";
    return facts;
}

std::vector<std::string> alarms_of(const WordRow& row) {
    std::vector<std::string> alarms;
    for (const RowAlarm& alarm : row.alarms) {
        if (alarm.number.empty()) continue;
        const ControlAlarm* known = find_alarm(alarm.control, alarm.number);
        alarms.push_back(std::string(alarm.control) + ": " + std::string(alarm.number) +
                         (known == nullptr ? "" : " " + std::string(known->title_on(alarm.control))));
    }
    return alarms;
}

/// A column as wide as the widest of the names.
std::string padded(std::string text, std::size_t width) {
    text.resize(std::max(text.size(), width), ' ');
    return text;
}

std::string list_entry(const RuleRow& row, const std::string& name, std::size_t widest, std::size_t width) {
    return "    " + padded(name, widest) + " " + std::string(name_of(row.first().severity)) +
           (row.on_by_default() ? "\n" : ", off\n") + below_name(sentence_of(row.rows.front()), width);
}

bool writes_for(const Dialect& dialect, const RuleRow& row) {
    const std::string_view language = find_control(dialect.default_control)->language;
    return std::ranges::any_of(row.rows,
                               [&](const RowForCode& entry) { return entry.table->language == language; });
}

void add_entry(PlainPage& page, const RuleRow& row, const RowForCode& entry,
               const std::vector<std::uint32_t>& marked) {
    page.add(sentence_of(entry));
    page.add(facts_of(row, *entry.row));
    page.add_heading("Where it holds:");
    page.add_item(where_of(entry));
    const auto alarms = alarms_of(*entry.row);
    if (!alarms.empty()) page.add_heading("Alarms it prevents:");
    for (const std::string& alarm : alarms) page.add_item(alarm);
    const RowExamples examples = examples_of(entry);
    page.add_example("Bad", Example(examples.dialect, examples.bad), marked);
    page.add_example("Good", Example(examples.dialect, examples.good), {});
    page.add_heading("Source:");
    page.add_source(entry.row->source);
}

} // namespace

std::string where_of(const RowForCode& row) {
    const WordTable& table = *row.table;
    std::string where(table.language);
    if (table.machine) where += *table.machine == Machine::mill ? " mills" : " lathes";
    if (!row.row->controls.empty()) where += ", on " + either_of(row.row->controls);
    std::string sections = either_of(row.row->sections.empty() ? table.sections : row.row->sections);
    std::ranges::replace(sections, '_', ' ');
    if (!sections.empty()) where += ", in " + sections;
    if (!row.row->under.empty()) where += ", under " + either_of(row.row->under);
    return where;
}

std::string markdown_rows(const Rule& rule) {
    const auto rows = rows_of(rule);
    if (rows.empty()) return {};
    std::string out =
        "\n## Rows\n\nEach can be named alone, as `" + rows.front().name() +
        "`; `maclint explain` shows its page.\n\n"
        "| key | what it says | where | severity | default | source |\n|---|---|---|---|---|---|\n";
    for (const RuleRow& row : rows)
        for (const RowForCode& entry : row.rows)
            out += "| " + row.key + " | " + sentence_of(entry) + " | " + where_of(entry) + " | " +
                   std::string(name_of(entry.row->severity)) + " | " + default_of(row) + " | " +
                   shown_source(entry.row->source) + " |\n";
    return out;
}

std::string plain_rows(const Rule& rule, const PageStyle& style) {
    const auto rows = rows_of(rule);
    if (rows.empty()) return {};
    PlainPage page(style);
    page.add_heading("Its rows, each to be named alone as " + rows.front().name() + ":");
    for (const RuleRow& row : rows)
        for (const RowForCode& entry : row.rows)
            page.add_item(row.key + " (" + std::string(name_of(entry.row->severity)) +
                          (row.on_by_default() ? "" : ", " + default_of(row)) + "; " + where_of(entry) +
                          "): " + sentence_of(entry));
    return page.take();
}

std::string list_of_rows(std::span<const RuleRow* const> rows, std::size_t width) {
    std::size_t widest = 0;
    for (const RuleRow* row : rows) widest = std::max(widest, row->name().size());
    std::string out;
    for (const RuleRow* row : rows) out += list_entry(*row, row->name(), widest, width);
    return out;
}

std::string list_below(const Rule& rule, std::size_t width) {
    constexpr std::size_t most_rows = 12;
    if (rows_of(rule).size() > most_rows)
        return "    /" + rows_of(rule).front().key + " and " + std::to_string(rows_of(rule).size() - 1) +
               " more rows: 'maclint explain " + std::string(rule.code) + "' lists them\n";
    std::size_t widest = 0;
    for (const RuleRow& row : rows_of(rule)) widest = std::max(widest, row.key.size() + 1);
    std::string out;
    for (const RuleRow& row : rows_of(rule)) out += list_entry(row, "/" + row.key, widest, width);
    return out;
}

std::string plain_row_page(const RuleRow& row, const PageStyle& style, const MarkedRows& marked) {
    PlainPage page(style);
    page.add_title(row.name() + " " + std::string(row.rule->name), family_of(*row.rule));
    for (std::size_t i = 0; i < row.rows.size(); ++i) {
        if (i > 0) page.add_empty_line();
        add_entry(page, row, row.rows[i], i < marked.size() ? marked[i] : std::vector<std::uint32_t>{});
    }
    page.add_heading("To allow it, at the end of the block or alone on the line before it:");
    page.add_to_copy(allowances(
        row.name(), [&](const Dialect& dialect) { return writes_for(dialect, row); }, "", "\n    "));
    page.add_empty_line();
    const std::string code(row.rule->code);
    page.add("'maclint explain " + code + "' says why it matters, and lists the other rows of " + code + ".");
    return page.take();
}

} // namespace maclint::cli
