//! Writes the rows of each code: of its words first, then of what is said of them.
#include "rules/words/book_rows.hpp"

#include "rules/words/code_pages.hpp"
#include "rules/words/word_list.hpp"

#include <algorithm>
#include <deque>
#include <map>
#include <string>
#include <utility>

namespace maclint {
namespace {

/// What comes of a row that is not kept, where its line does not say.
std::string_view usual_effect(RowStatement says) {
    switch (says) {
    case RowStatement::needs: return "the code lacks what it works with";
    case RowStatement::takes_not:
    case RowStatement::takes_only: return "the manual lists no such word";
    case RowStatement::excludes: return "each says the same in its own way";
    case RowStatement::only_with: return "without it the word says nothing";
    case RowStatement::values: return no_other_value;
    case RowStatement::whole: return "it counts";
    case RowStatement::alone: return "it is programmed in a block of its own";
    case RowStatement::apart: return "the control takes one of them";
    case RowStatement::precedes: return "it acts on that block";
    case RowStatement::refused: return "the manual gives it no place there";
    }
    return {};
}

/// Keeps what rows point to.
class Writer {
  public:
    std::vector<const WordTable*> tables() {
        std::vector<std::string_view> languages;
        for (const CodeBook* book : all_code_books()) {
            std::vector<WordRow> rows;
            for (const CodePage& page : all_code_pages())
                if (page.book == book) add_rows(page, rows);
            add_table(book->language, book->sections, std::move(rows));
            if (std::ranges::find(languages, book->language) == languages.end())
                languages.push_back(book->language);
        }
        for (const std::string_view language : languages) add_table(language, {}, rows_of_places(language));
        std::vector<const WordTable*> all;
        for (const WordTable& table : tables_) all.push_back(&table);
        return all;
    }

  private:
    void add_table(std::string_view language, std::string_view sections, std::vector<WordRow> rows) {
        rows_.push_back(std::move(rows));
        tables_.push_back({.language = language, .sections = sections, .rows = rows_.back()});
    }

    /// Where the codes of a language have no place: in the sections of other codes that are not theirs.
    std::vector<WordRow> rows_of_places(std::string_view language) {
        std::vector<std::string_view> all;
        std::map<std::string_view, std::vector<const CodePage*>> pages_of;
        for (const CodePage& page : all_code_pages()) {
            if (page.book->language != language) continue;
            for (const std::string_view section : words_of(page.sections()))
                if (std::ranges::find(all, section) == all.end()) all.push_back(section);
            for (const std::string_view code : words_of(page.head->row.code)) pages_of[code].push_back(&page);
        }
        std::vector<WordRow> rows;
        for (const auto& [code, pages] : pages_of) {
            std::string elsewhere;
            for (const std::string_view section : all)
                if (std::ranges::none_of(
                        pages, [&](const CodePage* page) { return has_word(page->sections(), section); }))
                    elsewhere.append(elsewhere.empty() ? "" : " ").append(section);
            if (elsewhere.empty()) continue;
            WordRow row = on_page(*pages.front(), *pages.front()->head, RowStatement::refused);
            row.code = code;
            row.sections = kept(std::move(elsewhere));
            row.severity = Severity::error;
            rows.push_back(row);
        }
        return rows;
    }

    std::string_view kept(std::string text) { return texts_.emplace_back(std::move(text)); }

    /// The row under the code of its page.
    WordRow on_page(const CodePage& page, const BookLine& line, RowStatement says) {
        WordRow row = line.row;
        row.says = says;
        row.code = page.head->row.code;
        row.sections = page.sections();
        if (row.effect.empty()) row.effect = usual_effect(says);
        if (row.means.empty()) row.means = meaning_on(page, row.words);
        row.source = kept(std::string(page.book->source) + ":" + std::to_string(line.line));
        return row;
    }

    static std::string_view meaning_on(const CodePage& page, std::string_view words) {
        for (const BookLine& line : page.lines)
            if (line.kind == BookLine::Kind::word && line.row.words == words) return line.row.means;
        return {};
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
        if (std::ranges::any_of(page.lines, [](const BookLine& line) {
                return line.kind == BookLine::Kind::statement && line.row.says == RowStatement::alone;
            }))
            return; // that row says so, too
        WordRow only = on_page(page, *page.head, RowStatement::takes_only);
        only.unless_later = {}; // that is said of other sections
        only.aliases = {};      // and those are codes of rules on its place
        only.words = kept(std::move(words));
        rows.push_back(only);
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
        rows.push_back(row);
    }

    static bool has_values(const WordRow& row) {
        return !row.values.empty() || row.least != -book::unbounded || row.most != book::unbounded;
    }
    static void clear_values(WordRow& row) {
        row.values = {};
        row.least = -book::unbounded;
        row.most = book::unbounded;
        row.above_least = row.below_most = false;
    }

    std::deque<std::string> texts_;
    std::deque<std::vector<WordRow>> rows_;
    std::deque<WordTable> tables_;
};

} // namespace

const std::vector<const WordTable*>& tables_of_books() {
    static Writer writer;
    static const auto tables = writer.tables();
    return tables;
}

} // namespace maclint
