//! Shifts, rotations and the like that a program has switched on for one tool or work offset, and keeps for
//! the next.
#pragma once

#include "analyzer/machine/step.hpp"

#include <map>
#include <optional>
#include <span>
#include <utility>

namespace maclint::machine {

/// A mode over a change of tool or work offset.
struct KeptMode {
    ModalRole role;
    Known mode;       ///< where it was switched on
    Offset change;    ///< the block of the change
    bool is_of_tools; ///< or of work offsets
};

class KeptModes {
  public:
    /// Takes in one block of the program after another, in the order of the text.
    void see(const Step& step, const ControlModel& control);
    /// The mode under which the block makes the first move behind a change, where the program ends it before
    /// each other change, or ends it at last; nothing where it keeps such modes again and again.
    [[nodiscard]] std::optional<KeptMode> at(Offset block) const;

  private:
    /// A mode, from where it is switched on.
    struct Stretch {
        int tools = 0, offsets = 0; ///< that were changed under it, and moved
        bool is_ended = false;
        std::optional<KeptMode> waiting; ///< for the first move behind a change
    };
    void see_mode(const Step& step, const ControlModel& control, ModalRole role);
    [[nodiscard]] bool is_meant(const KeptMode& kept) const;

    std::map<std::pair<ModalRole, Offset>, Stretch> stretches_; ///< by the block that switches on
    std::map<Offset, KeptMode> first_moves_;                    ///< by their blocks
};

} // namespace maclint::machine
