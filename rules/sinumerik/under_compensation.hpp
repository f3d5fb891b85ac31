//! What may not be done while radius compensation is in force.
#pragma once

#include "analyzer/workspace/program_analysis.hpp"
#include "rules/reporter.hpp"

#include <functional>
#include <string_view>

namespace maclint::rules {

/// From the block that switches compensation on to what may not be done then.
struct CompensationStretch {
    double code; ///< of the modal group
    Span begun;
    flow::NodeId begun_at;
    Span there;
    flow::NodeId at;
};

/// The arguments of the message: the code, the line that it stands on, what stands there, the code that ends
/// it.
void report_stretch(const ProgramAnalysis& analysis, std::string_view message, Reporter& reporter,
                    const CompensationStretch& stretch);

/// Reports each stretch of compensation that the program has switched on itself, and that is still in force,
/// on some path, at the first effect of a block that is `wanted`.
void report_under_compensation(const ProgramAnalysis& analysis, std::string_view message, Reporter& reporter,
                               const std::function<bool(EffectId)>& wanted);

} // namespace maclint::rules
