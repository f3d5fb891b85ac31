//! What a program does again and again: against which one block is held.
#pragma once

#include "analyzer/machine/arc.hpp"
#include "analyzer/machine/kept_modes.hpp"
#include "analyzer/machine/lift_watch.hpp"
#include "analyzer/machine/step.hpp"

#include <cstddef>
#include <map>
#include <optional>
#include <utility>

namespace maclint::machine {

class Habits {
  public:
    /// Takes in one block of the program after another, in the order of the text.
    void see(const Step& step, const Program& program);

    /// Whether anything moves.
    [[nodiscard]] bool is_of_interest() const { return moves_; }
    /// Whether it moves on circles or in canned cycles.
    [[nodiscard]] bool has_shapes() const { return has_shapes_; }
    /// Tools for which a length offset is chosen before the next one comes; the one that is in the spindle
    /// when the program starts only where it cuts with it.
    [[nodiscard]] int tools_with_length_offset() const { return tools_with_length_offset_; }
    [[nodiscard]] int changes() const { return changes_; }
    /// Whether the program turns the spindle by a word of its own.
    [[nodiscard]] bool turns_spindle() const { return turns_spindle_; }
    /// Tool changes after which the spindle is started before the tool cuts.
    [[nodiscard]] int changes_with_start() const { return changes_with_start_; }
    /// What still runs at a change of a tool that has worked, and how often it does and does not.
    struct AtChanges {
        int running = 0, off = 0;

        /// Whether the program switches it off before each change but one.
        [[nodiscard]] bool is_off_at_all_but_one() const { return running == 1 && off >= 2; }
    };
    [[nodiscard]] const AtChanges& spindle_at_changes() const { return spindle_at_changes_; }
    [[nodiscard]] const AtChanges& coolant_at_changes() const { return coolant_at_changes_; }
    [[nodiscard]] bool gives_feed() const { return gives_feed_; }
    [[nodiscard]] bool gives_speed() const { return gives_speed_; }
    /// Whether it works with a tool, a spindle or a feed at all: a few blocks that move are no such program.
    [[nodiscard]] bool is_of_a_machine() const {
        return names_tools_ || gives_feed_ || turns_spindle_ || gives_speed_;
    }
    /// Whether it names a tool anywhere.
    [[nodiscard]] bool names_tools() const { return names_tools_; }
    /// How often a tool has this offset.
    [[nodiscard]] int uses(double tool, double offset) const;
    /// The difference from tool to offset that all other pairs of the program have, `tool` with any offset
    /// left out; nothing where there are none or they differ.
    [[nodiscard]] std::optional<double> difference_beside(double tool) const;
    /// How many tools have an offset, and whether this one has.
    [[nodiscard]] int tools() const;
    [[nodiscard]] bool has_tool(double tool) const;
    /// Whether the tool has several offsets: then another one is meant.
    [[nodiscard]] bool has_several_offsets(double tool) const;
    /// What is wrong with the circle of the block that begins there; nullptr: nothing, or the program
    /// writes its circles so.
    [[nodiscard]] const Arc* wrong_arc(Offset block) const;

    /// Whether something is wrong with that circle, however the program writes its circles.
    [[nodiscard]] bool is_wrong_arc(Offset block) const { return wrong_arcs_.contains(block); }

    /// Where its tools are moved aside before they are lifted.
    [[nodiscard]] const LiftWatch& lifts() const { return lifts_; }

    /// What it keeps over a change of tool or work offset.
    [[nodiscard]] const KeptModes& kept_modes() const { return kept_modes_; }
    /// The last block that ends a length offset which the program has chosen; 0: there is none.
    [[nodiscard]] Offset last_end_of_length_offset() const { return last_end_of_length_offset_; }

    /// Of a lathe: how often the tool is taken far from its work before the turret turns, or may.
    [[nodiscard]] int retreats() const { return retreats_; }
    /// The largest X at which it cuts; nothing where nobody can say.
    [[nodiscard]] std::optional<double> widest_cut() const { return widest_cut_; }
    /// Whether the tool cuts with an offset somewhere; how many others do, and whether all others do.
    [[nodiscard]] bool cuts_with_offset(double tool) const;
    [[nodiscard]] int others_with_offset(double tool) const;
    [[nodiscard]] bool have_all_others_offset(double tool) const;

  private:
    void see_arc(const Step& step, const Program& program);
    void see_change(const Step& step, const ControlModel& control);
    void see_lathe(const Step& step, const ControlModel& control);

    bool moves_ = false, has_shapes_ = false, turns_spindle_ = false, gives_feed_ = false,
         gives_speed_ = false, names_tools_ = false;
    int changes_ = 0, tools_with_length_offset_ = 0, changes_with_start_ = 0;
    bool waits_for_offset_ = false, waits_for_start_ = false;
    AtChanges spindle_at_changes_, coolant_at_changes_;
    KeptModes kept_modes_;
    LiftWatch lifts_;
    Offset last_end_of_length_offset_ = 0;
    std::map<std::pair<double, double>, int> pairs_; ///< tool and offset
    std::map<Offset, Arc> wrong_arcs_;               ///< by their blocks
    std::size_t arcs_ = 0, odd_arcs_ = 0;            ///< circles; those whose numbers do not fit
    /// How often a tool cuts.
    struct Cuts {
        int with_offset = 0, without = 0;
    };
    std::map<double, Cuts> cuts_;
    int retreats_ = 0;
    std::optional<double> widest_cut_;
};

} // namespace maclint::machine
