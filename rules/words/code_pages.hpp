//! The codes of a language by their names: what its chapters say of each.
#pragma once

#include "rules/words/code_book.hpp"

#include <span>
#include <string_view>
#include <vector>

namespace maclint {

/// One code, or several that say the same, with what stands under it.
struct CodePage {
    const CodeBook* book;
    const BookLine* head;
    std::span<const BookLine> lines; ///< its words, then the statements on them

    /// Names of sections, blanks between them.
    [[nodiscard]] TableText sections() const {
        return head->row.sections.empty() ? book->sections : head->row.sections;
    }
    /// Whether the control has the code with these words.
    [[nodiscard]] bool is_of(const ControlModel& control) const;
};

/// Whether a line under a code of the control's holds on it.
[[nodiscard]] bool is_of(const BookLine& line, const ControlModel& control);

/// Those that chapters are of, each once.
[[nodiscard]] std::vector<std::string_view> languages_of_chapters();
/// Of one chapter.
[[nodiscard]] std::vector<CodePage> pages_of(const CodeBook& book);
/// Of all chapters of all languages, in their order.
[[nodiscard]] std::span<const CodePage> all_code_pages();
/// Those of one code, "G83", written as users do ("g083"); empty: no chapter has it.
[[nodiscard]] std::vector<const CodePage*> pages_of_code(std::string_view language, std::string_view code);
/// Whether a chapter of the control has the code, wherever it may stand.
[[nodiscard]] bool has_code_page(const ControlModel& control, char letter, double code);
/// Whether a chapter of any control of the language has it.
[[nodiscard]] bool has_page_anywhere(std::string_view language, char letter, double code);
/// Whether the chapters hold all G codes that the language's manual knows.
[[nodiscard]] bool has_all_codes(std::string_view language);
[[nodiscard]] bool has_all_codes(const ControlModel& control);

} // namespace maclint
