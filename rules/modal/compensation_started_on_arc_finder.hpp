//! Where cutter compensation is switched while a motion on an arc is in force.
#pragma once

#include "analyzer/queries/modal/modes_at.hpp"
#include "analyzer/workspace/program_analysis.hpp"

#include <cstdint>
#include <functional>
#include <optional>

namespace maclint::rules {

struct CompensationChange {
    enum class Kind : std::uint8_t {
        on,
        off,
        over, ///< to the other side, without being off in between
        side, ///< likewise, in a straight move, where the control wants it off in between
    } kind;
    GroupId group; ///< of the compensation
    double code;   ///< that the block gives
    GroupId motion;
    double moved; ///< the motion code in force
    Span block;
    flow::NodeId node;
    std::optional<queries::Mode>
        begins; ///< what makes it a fault, where that does not stand in the block itself
};

/// Calls the visitor for each block that moves on an arc and, on all paths, switches the compensation, and
/// where the control wants it off before it changes its side, for each that does so in a straight move. Left
/// out are blocks of which it is not known what was in force before, and those in which another code says how
/// to move: a cycle, a move to a reference position, a code that may call a macro.
void for_each_compensation_change_in_arc(const ProgramAnalysis& analysis,
                                         const std::function<void(const CompensationChange&)>& visit);

} // namespace maclint::rules
