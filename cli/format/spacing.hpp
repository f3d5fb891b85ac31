//! Blanks in the blocks of a file as somebody has chosen them.
#pragma once

#include "analyzer/dialect/dialect.hpp"
#include "analyzer/program/model.hpp"
#include "cli/config/spacing_choice.hpp"
#include "rules/finding.hpp"

#include <vector>

namespace maclint::cli {

/// What is to change in the blocks of that part, in the order of the text; the edits touch not. Remarks,
/// texts and what cannot be read stay as they are, and so does a block that would be read in another way.
/// None where the file would say anything else with all of them.
[[nodiscard]] std::vector<Edit> spacing_edits(const ProgramFile& file, const Dialect& dialect,
                                              const SpacingChoice& choice, Span part);

} // namespace maclint::cli
