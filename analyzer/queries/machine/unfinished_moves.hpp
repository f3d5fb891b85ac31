//! Positions that a program reads, and whether the axes have come to them by then.
#pragma once

#include "analyzer/dataflow/domain/value.hpp"
#include "analyzer/source/exemption.hpp"
#include "analyzer/workspace/program_analysis.hpp"

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace maclint::queries {

/// By which a position may be read while a move runs.
namespace exemptions {
inline constexpr Exemption distance_along_an_axis;
} // namespace exemptions

/// A machine value that tells where an axis is.
struct PositionRead {
    ExpressionId expression;
    flow::NodeId node;
    std::int32_t axis;          ///< from 0 on
    std::string_view addresses; ///< that move it; empty: any may
    bool subtracted;
    bool is_kept; ///< until the next move that a signal ends, whatever moves meanwhile
};

/// Which positions are meant.
enum class Positions : std::uint8_t {
    while_moving, ///< where the axes are
    when_touched, ///< where they are, and where a signal ended a move
    compared,     ///< the same, and those that are taken from each other: a way is asked for, too
};

/// The positions that decide the expression, which is evaluated at the effect: read there, or before and
/// stored in a variable since. Two of one axis of which one is taken from the other are none: they differ by
/// an offset, wherever the axis is.
[[nodiscard]] std::vector<PositionRead> positions_in(const ProgramAnalysis& analysis, EffectId effect,
                                                     ExpressionId expression,
                                                     Positions which = Positions::while_moving);

/// A move that the control may still be making when it computes what stands in a node.
struct UnfinishedMove {
    flow::NodeId node;
    Span span;
};

/// Whether a block takes look-ahead away from all that comes after it.
[[nodiscard]] bool limits_look_ahead(const Program& program);

/// The nearest such move of one of the addresses, or of any where there are none: no block that stops
/// look-ahead lies between, no call, and no M code that a parameter of the control may have made one that
/// does.
[[nodiscard]] std::optional<UnfinishedMove>
unfinished_move_before(const ProgramAnalysis& analysis, flow::NodeId node, std::string_view addresses);

} // namespace maclint::queries
