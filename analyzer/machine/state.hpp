//! What is known of the machine at one place of a program.
#pragma once

#include "analyzer/program/modal_groups.hpp"
#include "analyzer/program/variable.hpp"
#include "analyzer/source/span.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace maclint::machine {

/// A number that a program sets, and the block that sets it.
struct Known {
    enum class Kind : std::uint8_t {
        callers, ///< as it was when the program began
        unknown, ///< it differs from path to path, or nobody can say
        known,
        passed, ///< what the call has passed; `value` is the number of the variable
    };
    double value = 0;
    Offset block = 0; ///< where the block begins that set it
    Kind kind = Kind::callers;
    bool by_call = false; ///< a program has set it that the block calls

    [[nodiscard]] static constexpr Known of(double value, Offset block) {
        return {value, block, Kind::known};
    }
    [[nodiscard]] static constexpr Known nothing() { return {0, 0, Kind::unknown}; }
    [[nodiscard]] static constexpr Known passed_in(Variable variable, Offset block) {
        return {static_cast<double>(variable.number), block, Kind::passed};
    }
    [[nodiscard]] constexpr bool is_known() const { return kind == Kind::known; }
    [[nodiscard]] constexpr bool is_callers() const { return kind == Kind::callers; }
    [[nodiscard]] constexpr bool is_passed() const { return kind == Kind::passed; }
    [[nodiscard]] constexpr bool is(double number) const { return is_known() && value == number; }
};

/// Where the tool is in program coordinates, by axis; NaN: nobody can say. In the program's units.
using Position = std::array<double, 3>;
inline constexpr double nowhere = std::numeric_limits<double>::quiet_NaN();

/// The number of an offset that nobody has chosen since the tool was changed.
inline constexpr double not_since_change = -1;
/// The tool that a change has brought is in the spindle, and no other was prepared since.
inline constexpr double none_prepared = -1;

inline constexpr Offset no_block = std::numeric_limits<Offset>::max();

class State {
  public:
    bool is_reached = false;
    Known tool;          ///< in the spindle, or at the work
    Known prepared;      ///< the tool that the next change brings
    Known changed;       ///< the block of the last tool change
    Known length_offset; ///< number of the offset in force; not_since_change
    Known cutter_offset; ///< number of the offset of the cutter compensation
    Known speed_clamp;   ///< the highest speed of the spindle
    Known cycle_level;   ///< from where a canned cycle feeds (R)
    Known moved_in_z;    ///< 1: the tool has moved along its axis since it was changed; 0: not yet
    Known plunged;       ///< 1: it has fed down since the spindle was last started or stopped; 0: not yet
    Known cut;           ///< 1: it has cut since it was changed; 0: not yet
    /// 1: the block that set the distance mode ran to a reference position; 0: another block set it.
    Known distance_for_return;
    /// 1: rigid tapping is switched on; 2: and a block followed that may not stand before its cycle.
    Known rigid_tapping;
    Known profile_end; ///< number of the block that ends the profile of a roughing cycle; 0: none runs
    Known coolant;     ///< the function that switched it on or off
    /// Of the shop's demands (ShopDemands::blocks), a bit each: the block may stand before. Those of a tool
    /// change and of the end count since the last cut.
    std::uint64_t demands_met = 0;
    /// A path leads here on which no length offset was chosen since the tool change in this block.
    Offset without_offset_since = no_block;
    Offset offset_chosen_at = no_block; ///< where another path has chosen one
    Position position = {nowhere, nowhere, nowhere};
    Position cycle_start = {nowhere, nowhere, nowhere}; ///< where such a cycle began, and will end
    std::array<bool, 3> is_moved = {};                  ///< axes whose position this program has touched

    /// A modal group: the code, feed or speed in force. A group that the control lacks is the caller's.
    [[nodiscard]] const Known& of(ModalRole role) const { return modes_[static_cast<std::size_t>(role)]; }
    [[nodiscard]] Known& of(ModalRole role) { return modes_[static_cast<std::size_t>(role)]; }

    /// Whatever may have run may have changed all.
    void forget();
    void forget_modes();
    void forget_position();
    /// Takes in what another path says: what differs is unknown. Whether that changes anything.
    bool add(const State& other);
    /// By a word of a block.
    void choose_length_offset(Known offset) {
        length_offset = offset;
        without_offset_since = offset_chosen_at = no_block;
    }
    /// After a call of the block: what the called program has not touched is as before.
    void go_on_with(const State& end_of_called, Offset block);
    /// Puts numbers in the place of what calls have passed; `number_of(variable number)` is a Known.
    template<class NumberOf>
    void resolve_passed(const NumberOf& number_of) {
        for (Known* known : {&tool, &prepared, &length_offset, &cutter_offset})
            if (known->is_passed()) {
                const Known number = number_of(known->value);
                known->kind = number.kind;
                known->value = number.value;
            }
    }

  private:
    static constexpr std::size_t roles = static_cast<std::size_t>(ModalRole::feed_hold) + 1;

    /// Before `length_offset` takes in what the other path says.
    [[nodiscard]] bool add_missing_offset(const State& other);
    /// `visit(Known State::*…)` of two states in step.
    template<class Visit>
    static void for_each_two(State& a, const State& b, const Visit& visit);

    std::array<Known, roles> modes_;
};

} // namespace maclint::machine
