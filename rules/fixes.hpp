//! Fixes that several rules offer.
#pragma once

#include "rules/finding.hpp"

#include <string>

namespace maclint::rules {

/// The bytes to take away with a word or a comment: the blanks before it at the end of a line, those behind
/// it at the beginning, the whole line where nothing else stands on it.
[[nodiscard]] Span removal_of(const Source& source, Span part);

/// The text in place of the bytes; the title is "Write 'text'".
void offer_text(Finding& finding, Applicability applicability, Span span, std::string text);

/// Nothing in place of a word, as `removal_of` says. The title is "Remove 'word'".
void offer_removal(Finding& finding, Applicability applicability, Span span);

/// A block of its own in front of the one on whose line `place` begins: "Write 'G80' before it". It takes
/// over the number of that block, so that a jump to it runs both. Not where that block may be skipped, names
/// its channel, or is not the first on its line.
void offer_block_before(Finding& finding, Applicability applicability, Span place, const std::string& block);
/// On a line below the one in which `place` ends.
void offer_block_after(Finding& finding, Applicability applicability, Span place, const std::string& block);

} // namespace maclint::rules
