//! Recognises the lines that begin a section.
#pragma once

#include "analyzer/dialect/dinplus/tables.hpp"
#include "analyzer/source/span.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace maclint::dinplus {

/// A section word found in capital words.
struct FoundSection {
    const SectionWord* word;
    Offset length; ///< bytes of the text that it takes
    bool capitals; ///< it is written as the control wants it
};

/// The section word with which `words` begin: all of them, or all but what follows the first or second.
/// Any case, UTF-8 or Latin-1.
[[nodiscard]] std::optional<FoundSection> find_section(std::string_view words);

/// The row of ControlModel::sections that the word begins.
[[nodiscard]] const SectionKind& kind_of(const SectionWord& word);

/// How the control spells the section: the word itself, or the English one for a translated word.
[[nodiscard]] std::string spelling_of(const SectionWord& word);

/// Letters become capitals, Latin-1 becomes UTF-8.
[[nodiscard]] std::string capitals_of(std::string_view words);

} // namespace maclint::dinplus
