//! Rows about modal groups: which codes they have, and what a program may leave behind.
#pragma once

#include "analyzer/program/ids.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace maclint {

/// A member of a modal group: the number that the state holds, and how it is written where that is not the
/// group's letter and the number: DIAMON, or G18, which is the second member of its group.
struct ModalMember {
    constexpr ModalMember(
        double member_number) // NOLINT(google-explicit-constructor): tables are lists of them
        : number(member_number)
        , written_code(member_number) {}
    constexpr ModalMember(double member_number, std::string_view written)
        : number(member_number)
        , spelling(written)
        , written_code(code_in(written)) {}
    double number;
    std::string_view spelling = {};
    double written_code; ///< behind the group's letter; -1: it is written as a name

  private:
    static constexpr double code_in(std::string_view written) {
        constexpr double ten = 10;
        double code = written.size() < 2 ? -1 : 0;
        for (std::size_t i = 1; i < written.size() && code >= 0; ++i)
            code = written[i] >= '0' && written[i] <= '9' ? code * ten + (written[i] - '0') : -1;
        return code;
    }
};

/// What a modal group is about, in every language; a control has at most one group of each role but `other`.
enum class ModalRole : std::uint8_t {
    other,
    motion,              ///< rapid, straight, circle …
    plane,               ///< of circles and compensation
    distance,            ///< absolute or incremental
    units,               ///< inch or metric
    feed,                ///< the value itself
    feed_mode,           ///< a minute, a revolution, inverse time
    speed,               ///< of the spindle, the value itself
    speed_mode,          ///< constant surface speed or constant number of revolutions
    spindle,             ///< turns, stands
    cutter_compensation, ///< or that of a turning tool's nose
    length_compensation,
    work_offset,
    local_offset,      ///< added to the work offset until taken back
    offset_suspension, ///< work offsets switched off for a while
    cycle,             ///< canned cycles, which every later position runs
    return_level,      ///< where a canned cycle ends
    macro_call,        ///< a program called after every move or block
    cutting_mode,      ///< exact stop, tapping, override …
    scaling,
    rotation,
    mirror_image,
    tilted_plane,
    polar_coordinates,
    polar_interpolation,
    normal_direction,
    single_block, ///< its suppression
    feed_hold,    ///< its suppression, and that of the override
};

/// What a rule may say about a modal group that a program leaves changed.
enum class RestorePolicy : std::uint8_t {
    none,      ///< nothing: no custom asks to put it back
    state,     ///< a way of reading words (plane, distance, units): MAC501
    operation, ///< something that acts on every later move until cancelled: MAC502
    cycle,     ///< a canned cycle, which every later position runs until cancelled, at most to the program's
               ///< end: MAC502
    value,     ///< feed or speed: MAC503
    motion,    ///< the motion mode itself: MAC504
    offset,    ///< from where positions count, tool length and work offset: MAC519
    suppression, ///< single block, feed hold, override switched off: MAC515
    modal_call,  ///< a macro called after every move: MAC413
    own_rule,    ///< a rule of its own speaks of it, found by the group's role
};

/// One row of the modal-group table. Codes are numbers as written: 91, 54.1; feeds and speeds are plain
/// values.
struct ModalGroup {
    std::string_view name; ///< "distance mode": for messages
    ModalRole role;        ///< what rules and lowering find it by
    char letter;           ///< 'G', 'F', 'S'; '#' for a group that is a variable (single-block suppression)
    RestorePolicy restore_policy;
    std::vector<ModalMember> members; ///< codes of the group; empty for value groups
    std::vector<double> customary;    ///< codes that a program may leave behind without comment
    std::optional<double> cancel;     ///< the code that ends an operation (G40, G80)
    std::optional<double> reset; ///< the code in force in a main program's first block, where it is known
    std::string_view source;
    std::string_view cancel_words = {}; ///< how `cancel` is written where it is more than a code: "G16 Q0"
    bool watched = false;               ///< rules ask for the state in front of each word that sets it
    bool for_callers = false;           ///< a subprogram may switch it on for its caller, who is to cancel it
    /// Of a group whose code is a sum: what each of its bits switches off.
    std::vector<std::string_view> switched_off = {};
    std::vector<double> circles = {}; ///< of the motion mode: the codes that move on circles in a plane
    /// The group each of whose codes ends what this one has in force, as `cancel` does: G00 a canned cycle.
    std::optional<ModalRole> ended_by = {};
};

/// The row of that role, or nothing.
[[nodiscard]] std::optional<GroupId> group_with(ModalRole role, std::span<const ModalGroup> groups);

/// A code of a group.
struct GroupCode {
    GroupId group;
    double code;
};

/// A code of the group `by` sets another group to its cancelling code.
struct EndedGroup {
    GroupId by;
    GroupId group;
    double code;
};

/// While the code is in force, no move asks for the value: the feed at rapid traverse, the speed of a spindle
/// that stands.
struct Idle {
    GroupId value;
    GroupCode under;
    bool given_again =
        false; ///< who ends it gives the value again, by custom: a spindle starts with its speed
    bool other_meaning =
        false; ///< a word in its block may mean something else: to which angle a spindle turns
};

} // namespace maclint
