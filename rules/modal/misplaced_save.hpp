//! Findings of words that put back another group than the one that was changed.
#pragma once

#include "analyzer/workspace/program_analysis.hpp"
#include "rules/rule.hpp"

namespace maclint::rules {

/// Reports them with the messages "twice", "beside" and "unchanged": {0} is the save or the word, {1} the
/// other place, {2} the group, {3} the line of the save. Of a main program none is told.
void report_misplaced_saves(const ProgramAnalysis& analysis, Reporter& reporter);

} // namespace maclint::rules
