//! The jump that looks the other way.
#pragma once

#include "analyzer/workspace/program_analysis.hpp"
#include "rules/finding.hpp"

namespace maclint::rules {

/// The word of the other direction in place of the one that the jump begins with: GOTOB for GOTOF. Nothing
/// where the language has no such words.
void offer_other_direction(Finding& finding, const ProgramAnalysis& analysis, Span jump);

} // namespace maclint::rules
