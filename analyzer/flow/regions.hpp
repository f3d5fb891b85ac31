//! Pairs what opens with what closes: loops, choices, and every way in which the pairing goes wrong.
#pragma once

#include "analyzer/program/block_view.hpp"
#include "analyzer/program/model.hpp"

#include <optional>
#include <utility>
#include <vector>

namespace maclint::flow {

using RegionId = std::uint32_t;

/// One loop or choice of a program.
struct Region {
    RegionKind region_kind;
    EffectId open; ///< the effect that opens it
    std::vector<EffectId>
        parts; ///< what begins (THEN), divides (ELSE, CASE) and leaves it (BREAK), in text order
    std::optional<EffectId> close;         ///< absent: never closed
    bool crossed;                          ///< it overlaps another: it is unknown what the control repeats
    std::optional<RegionId> parent;        ///< the region that was open around it
    std::optional<RegionId> closed_around; ///< the innermost loop open around it that is closed at all
    std::optional<std::int64_t> number;
    std::optional<ExpressionId> condition;
};

enum class Imbalance : std::uint8_t {
    never_closed,    ///< DO without END
    never_opened,    ///< END without DO
    crossed,         ///< the close of an outer region stands inside an inner one that is closed later
    nested_too_deep, ///< opens a level beyond the control's limit; a unit inside a unit
    number_reused,   ///< opens with the number of a region still open
    number_out_of_range,
};

struct RegionFault {
    Imbalance what;
    EffectId effect; ///< the opening or closing effect at fault
    std::optional<EffectId>
        other; ///< its partner in the fault: the open loop with the same number, the crossed loop, the close
               ///< that is left over and may be meant for a loop that is never closed
};

struct Regions {
    std::vector<Region> all;         ///< in the order in which they open
    std::vector<RegionFault> faults; ///< in program order
    bool balance_unknown =
        false; ///< an unreadable block may open or close something: missing partners prove nothing
    std::vector<std::pair<EffectId, RegionId>>
        by_effect; ///< every effect that opens, divides, leaves or closes one of them, sorted

    /// The region that the effect opens, divides, leaves or closes.
    [[nodiscard]] std::optional<RegionId> with(EffectId effect) const;

    /// The innermost loop whose body holds this byte: after its opening effect, up to and including its
    /// closing block.
    [[nodiscard]] std::optional<RegionId> loop_around(const Program& program, Offset offset) const;
    /// Whether the body of `loop` holds this byte.
    [[nodiscard]] bool holds(const Program& program, RegionId loop, Offset offset) const;
    /// The outermost loop that a jump between these bytes enters past its head.
    [[nodiscard]] std::optional<RegionId> entered(const Program& program, Offset from, Offset to) const;
};

[[nodiscard]] Regions pair_regions(const Program& program);

} // namespace maclint::flow
