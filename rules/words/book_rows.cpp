//! Writes the rows of each code: of its words first, then of what is said of them.
#include "rules/words/address_book.hpp"
#include "rules/words/book_language.hpp"
#include "rules/words/code_pages.hpp"
#include "rules/words/code_places.hpp"
#include "rules/words/row_values.hpp"
#include "rules/words/usual_effect.hpp"
#include "rules/words/word_list.hpp"

#include <algorithm>
#include <deque>
#include <string>
#include <utility>

namespace maclint {
namespace {

/// Keeps what rows point to.
class Writer {
  public:
    std::vector<const WordTable*> tables() {
        for (const CodeBook* book : all_code_books()) {
            std::vector<WordRow> rows;
            for (const CodePage& page : pages_of(*book)) add_rows(page, rows);
            add_table(book->without_rows(), std::move(rows));
        }
        for (const std::string_view language : languages_of_chapters())
            add_table({.language = language, .rows = {}}, rows_of_places(language));
        for (const AddressBook* book : all_address_books())
            add_table({.language = book->language, .machine = book->machine, .rows = {}},
                      rows_of(*book, texts_));
        std::vector<const WordTable*> all;
        for (const WordTable& table : tables_) all.push_back(&table);
        return all;
    }

  private:
    void add_table(WordTable table, std::vector<WordRow> rows) {
        rows_.push_back(std::move(rows));
        table.rows = rows_.back();
        tables_.push_back(table);
    }

    /// Where the codes of a language have no place.
    std::vector<WordRow> rows_of_places(std::string_view language) {
        std::vector<WordRow> rows;
        for (PlacelessCode& code : codes_without_place(language)) {
            WordRow row = on_page(*code.page, *code.page->head, RowStatement::refused);
            row.code = kept(std::string(code.code));
            row.sections = kept(std::move(code.sections));
            row.severity = Severity::error;
            rows.push_back(row);
        }
        return rows;
    }

    TableText kept(std::string text) { return texts_.emplace_back(std::move(text)); }

    /// The row under the code of its page.
    WordRow on_page(const CodePage& page, const BookLine& line, RowStatement says) {
        WordRow row = line.row;
        row.says = says;
        row.code = page.head->row.code;
        row.sections = page.sections();
        if (row.controls.empty()) row.controls = page.head->row.controls;
        if (row.systems.empty()) row.systems = page.head->row.systems;
        if (row.effect.empty()) row.effect = usual_effect(says);
        if (row.means.empty()) row.means = meaning_on(page, row.words);
        row.source = line.source.empty()
                         ? kept(std::string(page.book->source) + ":" + std::to_string(line.line))
                         : line.source;
        return row;
    }

    static TableText meaning_on(const CodePage& page, std::string_view words) {
        for (const BookLine& line : page.lines)
            if (line.kind == BookLine::Kind::word &&
                (line.row.words == words || has_word(line.row.words, words)))
                return line.row.means;
        return meaning_of_address(page.book->language, words);
    }

    void add_rows(const CodePage& page, std::vector<WordRow>& rows) {
        std::string words;
        for (const BookLine& line : page.lines) {
            if (line.kind == BookLine::Kind::statement) {
                rows.push_back(on_page(page, line, line.row.says));
                continue;
            }
            words.append(words.empty() ? "" : " ").append(line.row.words);
            if (line.need == Need::likely || line.need == Need::sure) add_need(page, line, rows);
            if (has_values(line.row)) add_values(page, line, rows);
        }
        if (page.book->partial || page.head->row.in_calls) return; // words of a call are arguments
        if (std::ranges::any_of(page.lines, [](const BookLine& line) {
                return line.kind == BookLine::Kind::statement && line.row.says == RowStatement::alone;
            }))
            return; // that row says so, too
        WordRow only = on_page(page, *page.head, RowStatement::takes_only);
        only.unless_later = {}; // that is said of other sections
        only.aliases = {};      // and those are codes of rules on its place
        only.words = kept(std::move(words));
        if (!foreign_words(page.book->language, only.words).empty()) rows.push_back(only);
    }

    void add_need(const CodePage& page, const BookLine& line, std::vector<WordRow>& rows) {
        WordRow row = on_page(page, line, RowStatement::needs);
        clear_values(row);
        if (has_values(line.row)) row.aliases = {}; // they are of its values
        row.severity = line.need == Need::sure ? Severity::error : Severity::warning;
        rows.push_back(row);
    }

    void add_values(const CodePage& page, const BookLine& line, std::vector<WordRow>& rows) {
        WordRow row = on_page(page, line, RowStatement::values);
        if (line.need != Need::none)
            row.effect = usual_effect(RowStatement::values); // its own is of the need
        row.when = {};
        row.kept = false; // wherever it stands
        rows.push_back(row);
    }

    std::deque<std::string> texts_;
    std::deque<std::vector<WordRow>> rows_;
    std::deque<WordTable> tables_;
};

} // namespace

std::span<const WordTable* const> all_word_tables() {
    static Writer writer;
    static const auto tables = writer.tables();
    return tables;
}

} // namespace maclint
