//! Fixes for syntax errors.
#pragma once

#include "analyzer/program/model.hpp"
#include "rules/finding.hpp"

namespace maclint {

/// Offers what the reader of the language says that mends the error; else its cure, where that is a text to
/// be written in place of what is wrong.
void offer_remedy(const ProgramFile& file, const SyntaxError& error, Finding& finding);

} // namespace maclint
