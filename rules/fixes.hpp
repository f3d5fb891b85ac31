//! Fixes that several rules offer.
#pragma once

#include "rules/finding.hpp"

#include <string>

namespace maclint::rules {

/// The text in place of the bytes; the title is "Write 'text'".
void offer_text(Finding& finding, Applicability applicability, Span span, std::string text);

/// Nothing in place of a word, with the blanks before it; with its line where nothing else stands there. The
/// title is "Remove 'word'".
void offer_removal(Finding& finding, Applicability applicability, Span span);

/// A block of its own on a line above the one in which `place` begins: "Write 'G80' before it".
void offer_block_before(Finding& finding, Applicability applicability, Span place, const std::string& block);
/// On a line below the one in which `place` ends.
void offer_block_after(Finding& finding, Applicability applicability, Span place, const std::string& block);

} // namespace maclint::rules
