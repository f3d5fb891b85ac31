//! Remarks that say where the jump beside them goes, or which tool the block beside them calls.
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

/// A remark that begins with the number of a tool, and a tool beside it that is another.
struct OtherToolNamed {
    Span tool; ///< the word
    std::int64_t called;
    std::int64_t named;
    Span remark; ///< from its bracket on
};

/// Remarks such as `(T12 DRILL)`: in the line of the only T, which stands in no call, or alone in the line
/// before. A remark that follows another of that kind is part of a list. T1205 is tool 12 as well as tool 5.
/// In text order.
[[nodiscard]] std::vector<OtherToolNamed> find_other_tools_named(const ProgramAnalysis& analysis);

} // namespace maclint::rules
