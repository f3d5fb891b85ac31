//! Takes the sections of each code's pages from those of all.
#include "rules/words/code_places.hpp"

#include "rules/words/word_list.hpp"

#include <algorithm>
#include <map>

namespace maclint {

std::vector<PlacelessCode> codes_without_place(std::string_view language) {
    std::vector<std::string_view> sections;
    std::map<std::string_view, std::vector<const CodePage*>> pages_of;
    for (const CodePage& page : all_code_pages()) {
        if (page.book->language != language) continue;
        for (const std::string_view section : words_of(page.sections()))
            if (std::ranges::find(sections, section) == sections.end()) sections.push_back(section);
        for (const std::string_view code : words_of(page.head->row.code)) pages_of[code].push_back(&page);
    }
    std::vector<PlacelessCode> codes;
    for (const auto& [code, pages] : pages_of) {
        std::string elsewhere;
        for (const std::string_view section : sections)
            if (std::ranges::none_of(
                    pages, [&](const CodePage* page) { return has_word(page->sections(), section); }))
                elsewhere.append(elsewhere.empty() ? "" : " ").append(section);
        if (!elsewhere.empty()) codes.push_back({code, pages.front(), std::move(elsewhere)});
    }
    return codes;
}

} // namespace maclint
