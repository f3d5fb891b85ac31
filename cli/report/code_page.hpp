//! A code's page: its words, where it may stand, and the rules that watch it; for `explain` and the
//! documentation.
#pragma once

#include "cli/report/plain_page.hpp"
#include "rules/words/code_pages.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace maclint::cli {

/// `only`: as that control has it; nullptr: as all that have the code.
[[nodiscard]] std::string plain_code_page(const CodePage& page, const ControlModel* only,
                                          const PageStyle& style);

/// Markdown of a few lines for an editor: what it is on the control, how long it is in force, its words.
[[nodiscard]] std::string short_code_page(const CodePage& page, const ControlModel& control);
/// "depth of a peck (more than 0)": a word of the code on the control; nothing where it has no such word.
[[nodiscard]] std::optional<std::string> word_of_page(const CodePage& page, std::string_view address,
                                                      const ControlModel& control);

/// The chapters of a language: that on sections first.
[[nodiscard]] std::vector<const CodeBook*> books_of(std::string_view language);
/// Markdown of a chapter, a heading of the second level for each code.
[[nodiscard]] std::string markdown_chapter(const CodeBook& book);
/// Markdown that lists all codes of a language with links to their chapters.
[[nodiscard]] std::string markdown_codes(std::string_view language);
/// "turning-cycles.md".
[[nodiscard]] std::string chapter_file(const CodeBook& book);

/// In the folders of chapters: by it they are known again.
inline constexpr std::string_view codes_mark =
    "Made from the chapters of codes by `maclint rules --write-codes`.";

} // namespace maclint::cli
