//! Cuts the chapters into pages.
#include "rules/words/code_pages.hpp"

#include "analyzer/dialect/ascii.hpp"
#include "analyzer/program/tables.hpp"
#include "rules/words/row_place.hpp"
#include "rules/words/word_list.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <string>
#include <tuple>

namespace maclint {
namespace {

std::vector<CodePage> make_pages() {
    std::vector<CodePage> pages;
    for (const CodeBook* book : all_code_books())
        std::ranges::copy(pages_of(*book), std::back_inserter(pages));
    return pages;
}

using PageOfCode = std::tuple<std::string_view, char, double>; ///< language, letter, number

std::multimap<PageOfCode, const CodePage*> make_index() {
    std::multimap<PageOfCode, const CodePage*> index;
    for (const CodePage& page : all_code_pages())
        for (const std::string_view code : words_of(page.head->row.code))
            index.emplace(PageOfCode{page.book->language, code.front(), code_number_of(code)}, &page);
    return index;
}

const std::multimap<PageOfCode, const CodePage*>& index() {
    static const auto made = make_index();
    return made;
}

} // namespace

bool CodeBook::is_of_machine(const ControlModel& control) const {
    return language == control.language && (!machine || *machine == control.machine);
}

bool CodeBook::is_of(const ControlModel& control) const {
    return is_of_machine(control) && is_one_of(control, controls, {});
}

bool CodePage::is_of(const ControlModel& control) const {
    return book->is_of(control) && maclint::is_of(*head, control);
}

bool is_of(const BookLine& line, const ControlModel& control) {
    return is_one_of(control, line.row.controls, line.row.systems);
}

std::vector<std::string_view> languages_of_chapters() {
    std::vector<std::string_view> languages;
    for (const CodeBook* book : all_code_books())
        if (std::ranges::find(languages, book->language) == languages.end())
            languages.push_back(book->language);
    return languages;
}

std::vector<CodePage> pages_of(const CodeBook& book) {
    std::vector<CodePage> pages;
    for (std::size_t i = 0; i < book.lines.size();) {
        const BookLine& head = book.lines[i++];
        const std::size_t first = i;
        while (i < book.lines.size() && book.lines[i].kind != BookLine::Kind::code) ++i;
        pages.push_back({&book, &head, book.lines.subspan(first, i - first)});
    }
    return pages;
}

std::span<const CodePage> all_code_pages() {
    static const std::vector<CodePage> pages = make_pages();
    return pages;
}

std::vector<const CodePage*> pages_of_code(std::string_view language, std::string_view code) {
    const std::string name = in_capitals(code);
    const bool is_code = name.size() > 1 && name.find_first_not_of("0123456789.", 1) == std::string::npos;
    std::vector<const CodePage*> pages;
    if (!is_code) return pages;
    const auto [first, last] = index().equal_range({language, name.front(), code_number_of(name)});
    for (auto entry = first; entry != last; ++entry) pages.push_back(entry->second);
    return pages;
}

bool has_all_codes(std::string_view language) {
    const auto languages = languages_of_chapters();
    return std::ranges::find(languages, language) != languages.end();
}

bool has_all_codes(const ControlModel& control) { return has_all_codes(control.language); }

bool has_code_page(const ControlModel& control, char letter, double code) {
    const auto [first, last] = index().equal_range({control.language, letter, code});
    return std::any_of(first, last, [&](const auto& entry) { return entry.second->is_of(control); });
}

bool has_page_anywhere(std::string_view language, char letter, double code) {
    return index().contains({language, letter, code});
}

} // namespace maclint
