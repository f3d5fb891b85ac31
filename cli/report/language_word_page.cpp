//! Made from the tables of the language and from what rules say.
#include "cli/report/language_word_page.hpp"

#include "analyzer/program/language_words.hpp"
#include "cli/report/speaking_rules.hpp"
#include "cli/text/letters.hpp"
#include "rules/listed.hpp"

#include <algorithm>
#include <vector>

namespace maclint::cli {
namespace {

/// "function: root of a number"; of a word of which no more is known, its use.
std::string what_it_is(const LanguageWord& word) {
    return std::string(name_of(word.use)) + (word.what.empty() ? "" : ": " + std::string(word.what));
}

void add_cycle(PlainPage& page, const LanguageTables& tables, std::string_view name) {
    const auto cycle = std::ranges::find(tables.cycles, name, &BroughtCycle::name);
    if (cycle == tables.cycles.end()) return;
    if (!cycle->parameters.empty()) {
        page.add_heading("Its values, in this order:");
        page.add_item(rules::listed(
            std::vector<std::string>(cycle->parameters.begin(), cycle->parameters.end()), " and "));
    }
    if (cycle->wants_no_compensation) {
        page.add_heading("Before it:");
        page.add_item("radius compensation has to be off");
    }
}

} // namespace

std::string plain_language_word_page(const Dialect& dialect, std::string_view word, const PageStyle& style) {
    const std::string name = in_upper_case(word);
    const LanguageTables tables = dialect.words();
    const auto row = std::ranges::find(tables.words, name, &LanguageWord::word);
    const bool is_word = row != tables.words.end();
    const std::string about = is_word                            ? what_it_is(*row)
                              : tables.about_variable != nullptr ? tables.about_variable(name)
                                                                 : std::string();
    if (about.empty()) return {};
    PlainPage page(style);
    page.add_title(name, dialect.description);
    page.add(about);
    add_cycle(page, tables, name);
    const ControlModel* control = find_control(dialect.default_control);
    add_speaking_rules(page, name, {&control, 1});
    if (is_word && !row->source.empty()) {
        page.add_heading("Source:");
        page.add_source(row->source);
    }
    return page.take();
}

} // namespace maclint::cli
