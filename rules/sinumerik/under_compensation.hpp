//! What may not be done while radius compensation is in force.
#pragma once

#include "analyzer/workspace/program_analysis.hpp"
#include "rules/reporter.hpp"

#include <functional>
#include <string_view>

namespace maclint::rules {

/// Reports each stretch of compensation that the program has switched on itself, and that is still in force,
/// on some path, at the first effect of a block that is `wanted`. The arguments of the message: the code, the
/// line that it stands on, the effect, the code that ends it.
void report_under_compensation(const ProgramAnalysis& analysis, std::string_view message, Reporter& reporter,
                               const std::function<bool(EffectId)>& wanted);

} // namespace maclint::rules
