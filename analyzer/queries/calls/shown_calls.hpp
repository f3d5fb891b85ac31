//! Calls of a program that its own remarks show.
#pragma once

#include "analyzer/dataflow/domain/known_start.hpp"
#include "analyzer/workspace/program_analysis.hpp"

#include <vector>

namespace maclint::queries {

/// `(G65 P9100 X10. D5.)` in O9100.
struct ShownCall {
    Span span; ///< of the call, in the remark
    dataflow::KnownStart start;
};

/// In text order. Only of numbers that can be read; what stands behind others is unknown. None of a program
/// that somebody is known to call, or may be.
[[nodiscard]] std::vector<ShownCall> shown_calls(const ProgramAnalysis& analysis);

} // namespace maclint::queries
