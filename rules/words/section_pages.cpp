//! Finds a section in the chapters on sections.
#include "rules/words/section_pages.hpp"

#include "analyzer/dialect/ascii.hpp"
#include "analyzer/program/numbered_blocks.hpp"
#include "analyzer/program/tables.hpp"
#include "rules/words/word_list.hpp"

#include <algorithm>
#include <array>

namespace maclint {
namespace code_books {
extern const CodeBook dinplus_sections;
}

std::span<const CodeBook* const> all_section_books() {
    static constexpr std::array list = {&code_books::dinplus_sections};
    return list;
}

const BookLine* SectionPage::find(std::string_view address) const {
    const auto found = std::ranges::find(lines, address, [](const BookLine& line) { return line.row.words; });
    return found == lines.end() ? nullptr : &*found;
}

std::vector<CodePage> pages_named(std::string_view language, std::string_view name) {
    std::vector<CodePage> pages;
    for (const CodePage* page : pages_of_code(language, name)) pages.push_back(*page);
    std::string section = in_capitals(name);
    std::ranges::replace(section, ' ', '_');
    for (const CodeBook* book : all_section_books()) {
        if (book->language != language) continue;
        for (const CodePage& page : pages_of(*book))
            if (has_word(page.head->row.code, section)) pages.push_back(page);
    }
    return pages;
}

std::optional<SectionPage> page_of_section(const ControlModel& control, const Section& section) {
    const SectionKind* kind = kind_of(control, section);
    if (kind == nullptr) return std::nullopt;
    std::string name(kind->name);
    std::ranges::replace(name, ' ', '_');
    for (const CodeBook* book : all_section_books()) {
        if (book->language != control.language) continue;
        for (const CodePage& page : pages_of(*book))
            if (has_word(page.head->row.code, name))
                return SectionPage{std::string(kind->name), page.lines,
                                   kind->role == SectionKind::Role::information};
    }
    return std::nullopt;
}

} // namespace maclint
