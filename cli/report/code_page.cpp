//! Made from the chapters of codes, so that pages cannot say anything else than the rules do.
#include "cli/report/code_page.hpp"

#include "analyzer/dialect/dialect.hpp"
#include "cli/config/rule_words.hpp"
#include "rules/words/row_text.hpp"
#include "rules/words/row_values.hpp"
#include "rules/words/rule_row.hpp"
#include "rules/words/section_pages.hpp"
#include "rules/words/word_list.hpp"

#include <algorithm>
#include <utility>
#include <vector>

namespace maclint::cli {
namespace {

std::string title_of(const CodePage& page) {
    return all_of(page.head->row.code) + " " + std::string(page.head->row.means);
}

std::string source_of(const CodePage& page, const BookLine& line) {
    return std::string(page.book->source) + ":" + std::to_string(line.line);
}

/// "0, 1 or 2; 0 without it".
std::string remarks_of(const BookLine& word) {
    std::vector<std::string> remarks;
    if (has_values(word.row)) remarks.push_back(values_allowed_by(word.row));
    if (word.need == Need::sure) remarks.emplace_back("needed");
    if (word.need == Need::likely) remarks.emplace_back("needed by all that is known");
    if (word.need == Need::in_examples) remarks.emplace_back("in every example of the manual");
    if (!word.absent.empty()) remarks.push_back("without it: " + std::string(word.absent));
    std::string text;
    for (const std::string& remark : remarks) text += (text.empty() ? "" : "; ") + remark;
    return text;
}

/// Whether the row holds for the code of the page in one of its sections, or where it has no place.
bool is_of(const CodePage& page, const RowForCode& row) {
    if (row.table->language != page.book->language || !has_word(page.head->row.code, code_of(row)))
        return false;
    const std::string_view sections = row.row->sections.empty() ? row.table->sections : row.row->sections;
    return row.row->says == RowStatement::refused || sections.empty() ||
           has_word(sections, words_of(page.sections()).front());
}

/// What a row says of the code of a page.
struct RowOfPage {
    const RuleRow* rule_row;
    std::string says;
};

std::vector<RowOfPage> rows_of(const CodePage& page) {
    std::vector<RowOfPage> rows;
    for (const RuleRow& rule_row : all_rule_rows())
        for (const RowForCode& row : rule_row.rows)
            if (is_of(page, row)) rows.push_back({&rule_row, sentence_of(row)});
    return rows;
}

/// Rules that have the code in their names, "DIN906 g30-left-active", or the one on words of sections.
std::vector<const Rule*> rules_named_after(const CodePage& page) {
    std::vector<const Rule*> rules;
    if (page.sections().empty()) return {find_rule("DIN109")};
    for (const std::string_view code : words_of(page.head->row.code))
        for (const auto& [rule, row] : rules_meant(std::string(code)))
            if (row == nullptr) rules.push_back(rule);
    return rules;
}

std::string_view language_name(std::string_view language) {
    return find_dialect(language) == nullptr ? language : find_dialect(language)->name;
}

} // namespace

std::string plain_code_page(const CodePage& page, const PageStyle& style) {
    PlainPage out(style);
    out.add_title(title_of(page),
                  std::string(language_name(page.book->language)) + ", " + std::string(page.book->chapter));
    if (!page.sections().empty()) {
        out.add_heading("Where it may stand:");
        out.add_item(sections_in_words(page.sections()));
    }
    out.add_heading("Its words:");
    bool has_words = false;
    for (const BookLine& line : page.lines) {
        if (line.kind != BookLine::Kind::word) continue;
        has_words = true;
        const std::string remarks = remarks_of(line);
        out.add_item(std::string(line.row.words) + ": " + std::string(line.row.means) +
                     (remarks.empty() ? "" : " (" + remarks + ")"));
    }
    if (!has_words) out.add_item("none");
    out.add_heading("Rules that watch it:");
    for (const auto& [row, says] : rows_of(page))
        out.add_item(row->name() + (row->on_by_default() ? ": " : ", off: ") + says);
    for (const Rule* rule : rules_named_after(page))
        out.add_item(std::string(rule->code) + " " + std::string(rule->name) + ": " +
                     std::string(rule->summary) + ".");
    out.add_heading("Source:");
    out.add_source(source_of(page, *page.head));
    return out.take();
}

std::vector<const CodeBook*> books_of(std::string_view language) {
    std::vector<const CodeBook*> books;
    for (const auto all : {all_section_books(), all_code_books()})
        for (const CodeBook* book : all)
            if (book->language == language) books.push_back(book);
    return books;
}

std::string markdown_chapter(const CodeBook& book) {
    std::string out = "# " + std::string(book.chapter) + "\n\n" + std::string(codes_mark) + "\n";
    for (const CodePage& page : pages_of(book)) {
        out += "\n## " + title_of(page) + "\n\n" +
               (page.sections().empty() ? "" : "In " + sections_in_words(page.sections()) + "; ") +
               shown_source(source_of(page, *page.head)) + ".\n";
        bool is_first = true;
        for (const BookLine& line : page.lines) {
            if (line.kind != BookLine::Kind::word) continue;
            if (std::exchange(is_first, false))
                out += "\n| word | what it is | values | line |\n|---|---|---|---|\n";
            out += "| " + std::string(line.row.words) + " | " + std::string(line.row.means) + " | " +
                   remarks_of(line) + " | " + std::to_string(line.line) + " |\n";
        }
        out += "\n";
        for (const auto& [row, says] : rows_of(page))
            if (row->first().says != RowStatement::takes_only)
                out += "- " + says + " `" + row->name() + "`" + (row->on_by_default() ? "" : ", off") + "\n";
    }
    return out;
}

std::string markdown_codes(std::string_view language) {
    std::string out = "# Codes of " + std::string(language_name(language)) + "\n\n" +
                      std::string(codes_mark) + " `maclint explain G860 --dialect " + std::string(language) +
                      "` prints the same of one code.\n\n| code | what it is | chapter |\n|---|---|---|\n";
    for (const CodeBook* book : books_of(language))
        for (const CodePage& page : pages_of(*book))
            out += "| " + all_of(page.head->row.code) + " | " + std::string(page.head->row.means) + " | [" +
                   std::string(page.book->chapter) + "](" + chapter_file(*page.book) + ") |\n";
    return out;
}

std::string chapter_file(const CodeBook& book) {
    std::string name(book.chapter);
    std::erase(name, ',');
    std::ranges::replace(name, ' ', '-');
    return name + ".md";
}

} // namespace maclint::cli
