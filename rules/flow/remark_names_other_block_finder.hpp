//! Remarks beside a jump that say where it goes.
#pragma once

#include "analyzer/workspace/program_analysis.hpp"

#include <cstdint>
#include <vector>

namespace maclint::rules {

/// A remark that names one block of the program, and a jump beside it that goes to another.
struct OtherBlockNamed {
    EffectId jump;
    std::int64_t target; ///< of the jump
    std::int64_t named;
    Span remark; ///< from its bracket on
};

/// Remarks that say `GO TO N5` or `GOTO 5`, and no other block: in the line of a jump, or in a line of their
/// own where none of the jumps in the lines before and behind goes there. In text order.
[[nodiscard]] std::vector<OtherBlockNamed> find_other_blocks_named(const ProgramAnalysis& analysis);

} // namespace maclint::rules
