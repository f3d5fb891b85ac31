//! Watches where tools are moved aside at a depth, and lifted behind that.
#pragma once

#include "analyzer/machine/step.hpp"

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace maclint::machine {

/// A rapid move aside with the tool as deep as it has cut, and the block behind it that lifts the tool.
struct LateLift {
    Span block;
    double z;  ///< where the tool stands, in the program's unit, below 0
    Span lift; ///< in this program, or the call of the one that lifts
};

/// What a block does in Z, and beside it.
struct SideMove {
    Span block;
    bool rapid, feed, to_reference;
    bool aside, in_z; ///< which axes stand in the block
    double z_before, z_after;
    std::array<bool, 2> axes;        ///< of X and Y
    bool sets_compensation;          ///< of the cutter
    std::array<double, 2> x_y_after; ///< not a number where it is not known
};

/// A move aside at a depth, and the call behind it.
struct AsideBeforeCall {
    SideMove aside;
    Span call; ///< its block
};

class LiftWatch {
  public:
    /// One block of the program after another, in the order of the text.
    void see(const Step& step);

    /// X and Y move at rapid traverse behind a cut, then Z alone goes up to 0 or higher, and there the tool
    /// goes down again where it stands, or the tool has not been there at this depth; or all of them return
    /// to the reference position in this order.
    [[nodiscard]] std::span<const LateLift> lifts() const { return lifts_; }
    [[nodiscard]] std::span<const AsideBeforeCall> before_calls() const { return before_calls_; }
    /// Whether the program begins by lifting a tool that another one has left aside, as above.
    [[nodiscard]] bool begins_with_lift_of(const SideMove& aside) const;

  private:
    void add(const SideMove& move);
    /// Whether X and Y go to a place, by a block with both, where the tool was not since it is down.
    [[nodiscard]] bool leads_elsewhere(const SideMove& aside) const;

    struct Lifted {
        LateLift late;
        double z; ///< to which the tool was lifted
    };
    bool is_down_ = false;                      ///< the tool has fed down, and was not lifted since
    bool after_call_ = false;                   ///< the called program may have fed down
    std::vector<std::array<double, 2>> places_; ///< in X and Y, where blocks have led since the tool is down
    bool has_cut_ = false;                      ///< by one of them at least
    bool compensates_ = false; ///< one of them sets cutter compensation: they follow an outline, and leave it
    std::optional<SideMove> aside_;
    std::optional<Lifted> lifted_;
    std::vector<LateLift> lifts_;
    std::vector<AsideBeforeCall> before_calls_;
    std::vector<SideMove> first_; ///< the first two moves
};

} // namespace maclint::machine
