//! Made from the chapters of codes, so that pages cannot say anything else than the rules do.
#include "cli/report/code_page.hpp"

#include "analyzer/dialect/dialect.hpp"
#include "cli/report/code_watchers.hpp"
#include "cli/report/force_words.hpp"
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

/// A key with its place.
std::string source_of(const CodePage& page, const BookLine& line) {
    if (!line.source.empty()) return std::string(line.source);
    return std::string(page.book->source) + (line.line == 0 ? "" : ":" + std::to_string(line.line));
}

/// Those of the page: of lines of one manual that of the code alone, else each key once.
std::vector<std::string> sources_of(const CodePage& page) {
    std::vector<std::string> sources = {source_of(page, *page.head)};
    for (const BookLine& line : page.lines)
        if (!line.source.empty() && std::ranges::find(sources, line.source.view()) == sources.end())
            sources.emplace_back(line.source.view());
    return sources;
}

/// "0, 1 or 2; 0 without it".
std::string remarks_of(const BookLine& word, const ControlModel* only) {
    std::vector<std::string> remarks;
    if (has_values(word.row)) remarks.push_back(values_allowed_by(word.row));
    if (word.need == Need::sure) remarks.emplace_back("needed");
    if (word.need == Need::likely) remarks.emplace_back("needed by all that is known");
    if (word.need == Need::in_examples) remarks.emplace_back("in every example of the manual");
    if (!word.absent.empty()) remarks.push_back("without it: " + std::string(word.absent));
    if (const std::string where = narrowed_to(word.row); only == nullptr && !where.empty())
        remarks.push_back("only on " + where);
    std::string text;
    for (const std::string& remark : remarks) text += (text.empty() ? "" : "; ") + remark;
    return text;
}

std::string_view language_name(std::string_view language) {
    return find_dialect(language) == nullptr ? language : find_dialect(language)->name;
}

/// Whose codes a chapter has: "dinplus", "FANUC mills", "Haas lathes, system B".
std::string owner_of(const CodePage& page, const ControlModel* only) {
    if (only != nullptr) return only->description + (only->machine == Machine::mill ? ", mill" : "");
    const CodeBook& book = *page.book;
    if (book.controls.empty() && !book.machine) return std::string(language_name(book.language));
    std::string makers;
    for (const ControlModel* control : controls_of(page, nullptr)) {
        std::string maker = control->description.substr(0, control->description.find_first_of(" ,"));
        if (!has_word(makers, maker)) makers += (makers.empty() ? "" : " ") + maker;
    }
    std::string owner = all_of(makers);
    if (book.machine) owner += *book.machine == Machine::mill ? " mills" : " lathes";
    if (!page.head->row.systems.empty()) owner += ", " + systems_in_words(page.head->row.systems);
    return owner;
}

std::string with_remarks(const BookLine& word, const ControlModel* only) {
    const std::string remarks = remarks_of(word, only);
    return std::string(word.row.means) + (remarks.empty() ? "" : " (" + remarks + ")");
}

bool is_word_on(const BookLine& line, const ControlModel* only) {
    return line.kind == BookLine::Kind::word && (only == nullptr || maclint::is_of(line, *only));
}

/// One that nobody has named may be any of its language: nullptr.
const ControlModel* control_meant(const ControlModel& control) {
    return control.assumed ? nullptr : &control;
}

/// Under its group, on a control that has the code.
std::vector<std::string> force_on(const CodePage& page, const ControlModel* only) {
    const auto on = controls_of(page, only);
    if (on.empty() || is_section(page)) return {};
    return force_of(*on.front(), words_of(page.head->row.code));
}

} // namespace

std::string plain_code_page(const CodePage& page, const ControlModel* only, const PageStyle& style) {
    PlainPage out(style);
    out.add_title(title_of(page), owner_of(page, only) + ", " + std::string(page.book->chapter));
    if (!page.sections().empty()) {
        out.add_heading("Where it may stand:");
        out.add_item(sections_in_words(page.sections()));
    }
    if (const auto force = force_on(page, only); !force.empty()) {
        out.add_heading("In force:");
        for (const std::string& line : force) out.add_item(line);
    }
    out.add_heading("Its words:");
    bool has_words = false;
    for (const BookLine& line : page.lines) {
        if (!is_word_on(line, only)) continue;
        has_words = true;
        out.add_item(std::string(line.row.words) + ": " + with_remarks(line, only));
    }
    if (!has_words) out.add_item("none");
    out.add_heading("Rules that watch it:");
    const auto rows = rows_watching(page, only);
    const auto rules = rules_watching(page, only);
    for (const auto& [row, says] : rows)
        out.add_item(row->name() + (row->on_by_default() ? ": " : ", off: ") + says);
    for (const Rule* rule : rules)
        out.add_item(std::string(rule->code) + " " + std::string(rule->name) + ": " +
                     std::string(rule->summary) + ".");
    if (rows.empty() && rules.empty()) out.add_item("none");
    const auto sources = sources_of(page);
    out.add_heading(sources.size() == 1 ? "Source:" : "Sources:");
    for (const std::string& source : sources) out.add_source(source);
    return out.take();
}

namespace {

/// "In MACHINING and SUBPROGRAM; ", "On FANUC mills; ".
std::string places_of(const CodePage& page) {
    if (!page.sections().empty()) return "In " + sections_in_words(page.sections()) + "; ";
    return page.book->controls.empty() ? "" : "On " + owner_of(page, nullptr) + "; ";
}

/// Whether lines of one manual are its sources.
bool counts_lines(const CodeBook& book) {
    return std::ranges::all_of(book.lines, [](const BookLine& line) { return line.source.empty(); });
}

} // namespace

std::string short_code_page(const CodePage& page, const ControlModel& control) {
    std::string text = "**" + all_of(page.head->row.code) + "** " + std::string(page.head->row.means);
    for (const std::string& line : force_on(page, &control)) text += "\n- " + line;
    const ControlModel* only = control_meant(control);
    for (const BookLine& line : page.lines)
        if (is_word_on(line, only))
            text += "\n- `" + std::string(line.row.words) + "` " + with_remarks(line, only);
    return text;
}

std::optional<std::string> word_of_page(const CodePage& page, std::string_view address,
                                        const ControlModel& control) {
    const ControlModel* only = control_meant(control);
    for (const BookLine& line : page.lines)
        if (is_word_on(line, only) && has_word(line.row.words, address)) return with_remarks(line, only);
    return std::nullopt;
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
        out += "\n## " + title_of(page) + "\n\n" + places_of(page) +
               shown_source(source_of(page, *page.head)) + ".\n";
        std::string force;
        for (const std::string& line : force_on(page, nullptr)) force += (force.empty() ? "" : "; ") + line;
        if (!force.empty()) out += "\nIn force: " + force + ".\n";
        bool is_first = true;
        for (const BookLine& line : page.lines) {
            if (line.kind != BookLine::Kind::word) continue;
            if (std::exchange(is_first, false))
                out += "\n| word | what it is | values | " +
                       std::string(counts_lines(book) ? "line" : "source") + " |\n|---|---|---|---|\n";
            out += "| " + std::string(line.row.words) + " | " + std::string(line.row.means) + " | " +
                   remarks_of(line, nullptr) + " | " +
                   (counts_lines(book) ? std::to_string(line.line) : source_of(page, line)) + " |\n";
        }
        out += "\n";
        for (const auto& [row, says] : rows_watching(page, nullptr))
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
