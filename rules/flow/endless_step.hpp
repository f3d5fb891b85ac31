//! What MAC320 says of a step.
#pragma once

#include "analyzer/dataflow/facts/store.hpp"
#include "analyzer/queries/loops/loop_steps.hpp"
#include "rules/reporter.hpp"

namespace maclint::rules {

/// Of the first step of the counter, with the call that passes 0, or a wrong sign, where one is known; a note
/// where all known calls pass another number.
Finding& report_step(const ProgramAnalysis& analysis, Reporter& reporter, const queries::Counter& counter,
                     queries::StepFault fault);

} // namespace maclint::rules
