//! Blocks in a row that no path reaches.
#pragma once

#include "analyzer/source/exemption.hpp"
#include "analyzer/workspace/program_analysis.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace maclint::queries {

/// By which blocks are taken for left out on purpose.
namespace exemptions {
inline constexpr Exemption remark_behind_jump;
} // namespace exemptions

struct UnreachedRegion {
    flow::NodeId first, last;
    Span text;                          ///< of all its blocks
    Span head;                          ///< its first block
    std::optional<std::int64_t> number; ///< of its first block
    std::optional<EffectId> ender;      ///< the jump, stop or return before it, which never goes on
    std::optional<Span> work;           ///< the first block that does more than stop, wait and jump
    std::vector<EffectId> alarms;
    bool is_alarm = false;     ///< it leads straight to the first of them
    bool is_named = false;     ///< such a one whose number the text names elsewhere: "low battery: N801"
    bool leaves = false;       ///< a block of it ends the program or returns
    bool moves = false;        ///< some block moves or calls
    bool only_switches = true; ///< no block moves, calls or stores
    bool is_meant = false;     ///< a remark stands behind the jump before it
    /// Text in it is unreadable, its number stands twice, or a jump or a called program looks for a number
    /// that no block bears.
    bool is_explained = false;
};

/// In text order. Parts that are never executed at all, such as lists and contours, are none, and so is what
/// stands behind a call that does not return. None at all where loops or branches do not match: nobody knows
/// where paths lead there.
[[nodiscard]] std::vector<UnreachedRegion> unreached_regions(const ProgramAnalysis& analysis);

} // namespace maclint::queries
