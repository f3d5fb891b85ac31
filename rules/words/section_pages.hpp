//! What the manual says of the words of a section's description.
#pragma once

#include "rules/words/code_pages.hpp"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace maclint {

struct Section;

struct SectionPage {
    std::string name; ///< "FACE_Y"
    std::span<const BookLine> lines;
    bool describes_by_blocks; ///< its words stand in blocks below its name, too

    /// nullptr: the section does not take the word.
    [[nodiscard]] const BookLine* find(std::string_view address) const;
};

/// Nothing: the manual says nothing of the words of such sections.
[[nodiscard]] std::optional<SectionPage> page_of_section(const ControlModel& control, const Section& section);

/// The pages of a code or of a section, as users write them: "g0860", "face_c", "CHUCKING EQUIPMENT".
[[nodiscard]] std::vector<CodePage> pages_named(std::string_view language, std::string_view name);

/// The chapter on sections of each language that has one.
[[nodiscard]] std::span<const CodeBook* const> all_section_books();

} // namespace maclint
