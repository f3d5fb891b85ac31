//! What cannot be read, in parts of a program where no path leads.
#pragma once

#include "analyzer/source/exemption.hpp"
#include "analyzer/workspace/program_analysis.hpp"

#include <optional>
#include <vector>

namespace maclint::queries {

/// By which text that cannot be read, and never is, is let pass.
namespace exemptions {
inline constexpr Exemption text_that_is_no_slip;
inline constexpr Exemption text_left_out;
inline constexpr Exemption text_that_is_prose;
} // namespace exemptions

struct UnreachedText {
    const SyntaxError* error; ///< of the file
    Span block;               ///< in which it stands
    Span region;              ///< all the blocks around it that nothing reaches
    /// A block with a slip of the pen, which was to run or may be put back: no remark, separator or text
    /// behind the program's end, and nothing that somebody passes on purpose.
    bool is_program_text = false;
    std::optional<EffectId> lost_jump; ///< before the region: it names a number that no block bears
};

/// In text order. Parts that are never executed at all, such as lists and contours, are none.
[[nodiscard]] std::vector<UnreachedText> unreached_text(const ProgramAnalysis& analysis);

} // namespace maclint::queries
