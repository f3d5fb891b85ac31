//! Offsets of the control that programs read and write by their numbers.
#pragma once

#include "analyzer/dataflow/facts/read.hpp"
#include "analyzer/workspace/program_analysis.hpp"

#include <vector>

namespace maclint::queries {

/// Whether the assignment stores into an offset, or another value of the machine that keeps what is stored:
/// #5221, or #[5220+#1], in whose index a number leads there.
[[nodiscard]] bool makes_offset(const ProgramAnalysis& analysis, const Assign& assign);

/// A variable that picks an offset.
struct OffsetPick {
    const dataflow::Read* read; ///< of the variable, in the sum with the number of the first offset
    ExpressionId index;
};

/// Variables that are added to such a number in an index: #7 in `#[2000+#7]`.
[[nodiscard]] std::vector<OffsetPick> offset_picks(const ProgramAnalysis& analysis);

} // namespace maclint::queries
