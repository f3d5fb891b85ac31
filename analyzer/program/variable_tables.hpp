//! Rows about variables: their spaces, and what the numbers of a family stand for.
#pragma once

#include "analyzer/program/ids.hpp"
#include "analyzer/program/variable.hpp"

#include <cstdint>
#include <limits>
#include <optional>
#include <string_view>
#include <vector>

namespace maclint {

/// How long a variable lives and who shares it.
enum class Scope : std::uint8_t {
    frame,    ///< one set for every call level (local variables)
    shared,   ///< shared by all programs, lost when the control is switched off
    retained, ///< shared by all programs, kept when the control is switched off
    machine,  ///< owned by the control: offsets, outputs, counters
};

/// What a variable reads as before anything was stored in it.
enum class InitialValue : std::uint8_t { vacant, zero, undefined, old_value };

/// One row of the variable-space table.
struct VariableSpace {
    std::string_view name;   ///< "local variable"
    std::string_view prefix; ///< how a variable of it is written before its number: "#"
    bool named; ///< a variable's number is that of a name (Names; SharedNames where programs share it), not
                ///< part of the spelling
    Scope scope;
    InitialValue initial_value;
    std::string_view source;
    std::vector<std::string_view> fixed_names =
        {}; ///< how its variables are spelled after the prefix, by number
    bool handed_down =
        false; ///< a program may hand variables of it down to all that it calls (Program::handed_down)
    bool written_once = false;                ///< constants: only their definition writes them
    VariableType type = VariableType::number; ///< of variables that no declaration speaks of
};

/// What happens when a value is stored in a variable of a range.
enum class OnWrite : std::uint8_t { store, set_modal, alarm, pause, forbidden };

/// What a variable number stands for.
enum class Meaning : std::uint8_t {
    null,     ///< the null variable: always vacant
    variable, ///< an ordinary variable of `space`
    modal,    ///< reads the code in force of `group`
    machine,  ///< a value that the machine owns
    absent,   ///< no such variable on this control
};

/// One row of a family of variable numbers; rows of a family do not overlap and are sorted by `first`.
struct VariableRange {
    std::int32_t first, last;
    Meaning meaning;
    SpaceId space; ///< for variables and for machine values that can be written
    GroupId group; ///< for Meaning::modal and OnWrite::set_modal
    OnWrite on_write;
    bool changes_by_itself; ///< inputs, timers, positions: a loop that waits for it can end
    std::string_view what;  ///< "modal G code of group 03"
    std::string_view source;
    bool is_bit = false;        ///< 0 or 1, nothing else
    bool is_code = false;       ///< a modal code, of which group is not known
    bool may_be_vacant = false; ///< of machine values: there may be none, as of a probe that touched nothing
    std::optional<double> last_number = {}; ///< of machine values: whole numbers from 0 to this
    /// The positions of the axes, even while they move, `first` that of the first axis: for each the
    /// addresses that move it, blanks between the axes. Of more axes than stand here any address may. Empty:
    /// no positions.
    std::string_view positions_of = {};
    /// Where the axes were when a signal ended a move; the end of that move where none came.
    bool is_skip_position = false;
    bool is_output = false; ///< what a program stores there the machine hears at once
    /// Of numbers that go by axes, `first` that of the first axis: how many a set of axes takes; the next set
    /// begins so many further on. 0: they do not.
    std::int32_t numbers_of_a_set = 0;
    /// Of work offsets: the code under which the first set counts; the next set has the next code.
    std::optional<double> first_code = {};
    bool counts_from_machine = false; ///< of positions: in coordinates of the machine, not of the program
    bool is_block_end = false;        ///< positions where the last block has ended, as it was programmed

    /// The axis of a number that goes by axes, from 1 on; 0 for others.
    [[nodiscard]] std::int32_t axis(std::int32_t number) const {
        return numbers_of_a_set == 0 ? 0 : (number - first) % numbers_of_a_set + 1;
    }
    /// The code under which an offset counts; only where there is a first one.
    [[nodiscard]] double code(std::int32_t number) const {
        const std::int32_t set = (number - first) / numbers_of_a_set;
        return *first_code + set;
    }
};

/// What programmers mean by an index of which too little is known. An assumption: no control enforces it.
struct IndexCustom {
    /// `#[2000+#1]`: with a number of this size in a sum, or more, the sum is that number or up to `reach`
    /// more; what is taken away from such a number does not lead to local variables either.
    double least_base = std::numeric_limits<double>::infinity();
    double reach = 0;
    /// `#[#111+6]`: variables that all programs share point to variables that all programs share.
    bool shared_points_to_shared = false;
    /// `#[#1]=#0`: what counts the index is not among what it reaches.
    bool spares_index = false;
    std::string_view source = {};
};

/// All variable numbers that one kind of index can reach (`#[…]`).
struct VariableFamily {
    std::string_view name;
    std::vector<VariableRange> ranges;
    IndexCustom custom = {};
    /// The row that holds `number`, or nullptr.
    [[nodiscard]] const VariableRange* find(std::int64_t number) const;
};

} // namespace maclint
