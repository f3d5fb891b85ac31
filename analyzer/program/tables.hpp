//! The row types of the fact tables: what a control knows, told to the analysis as data.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace maclint {

using SpaceId = std::uint8_t;         ///< row of ControlModel::spaces
using GroupId = std::uint8_t;         ///< row of ControlModel::groups
using FamilyId = std::uint8_t;        ///< row of ControlModel::families
using CallKindId = std::uint8_t;      ///< row of ControlModel::calls
using ReferenceKindId = std::uint8_t; ///< row of ControlModel::references

/// A member of a modal group: the number that the state holds, and how it is written where that is not the
/// group's letter and the number (DIAMON).
struct ModalMember {
    constexpr ModalMember(
        double member_number) // NOLINT(google-explicit-constructor): tables are lists of them
        : number(member_number) {}
    constexpr ModalMember(double member_number, std::string_view written)
        : number(member_number)
        , spelling(written) {}
    double number;
    std::string_view spelling = {};
};

/// How long a variable lives and who shares it.
enum class Scope : std::uint8_t {
    frame,    ///< one set for every call level (local variables)
    shared,   ///< shared by all programs, lost when the control is switched off
    retained, ///< shared by all programs, kept when the control is switched off
    machine,  ///< owned by the control: offsets, outputs, counters
};

/// What a variable reads as before anything was stored in it.
enum class InitialValue : std::uint8_t { vacant, zero, undefined, old_value };

/// What a variable can hold. What is stored in an integer is rounded, in a truth it becomes 0 or 1.
enum class VariableType : std::uint8_t { number, integer, text, truth };

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

/// One variable: a space and a number (for named variables the index of the name in its program).
struct Variable {
    SpaceId space;
    std::int32_t number;
    friend bool operator==(const Variable&, const Variable&) = default;
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
};

/// The row of that role, or nothing.
[[nodiscard]] std::optional<GroupId> group_with(ModalRole role, std::span<const ModalGroup> groups);

/// A code of a group.
struct GroupCode {
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

/// Numbers of programs, both included; none where `last` is 0.
struct ProgramNumbers {
    std::int64_t first = 0, last = 0;
    [[nodiscard]] constexpr bool contains(std::int64_t number) const {
        return last != 0 && first <= number && number <= last;
    }
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

/// Whether a call opens a fresh set of local variables.
enum class Frame : std::uint8_t { fresh, shared };
/// Which limit a call counts against.
enum class NestingLimit : std::uint8_t { macro, subprogram };
/// When the called program runs.
enum class CallTrigger : std::uint8_t { once, after_each_motion, after_each_block };
/// Where the called program is looked for.
enum class LookupScope : std::uint8_t { everywhere, same_file, other_files };

/// One row of the call table.
struct CallKind {
    std::string_view name; ///< "G65 macro call"
    Frame frame;
    NestingLimit counts_against;
    CallTrigger trigger;
    double modal_code; ///< the code in force in the modal-call group while it acts; 0 for a call made once
    std::string_view source;
    LookupScope lookup = LookupScope::everywhere;
};

/// One row of the section table: a part of a program that a word of its own begins.
struct SectionKind {
    std::string_view name; ///< "MACHINING"
    enum class Role : std::uint8_t {
        information, ///< what the control reads when the program is loaded: head, tools, names
        contour,     ///< describes shapes; its blocks are what references mean
        machining,   ///< runs
        subprogram,
        end, ///< nothing may follow
    } role;
    bool required; ///< a main program must have it
    std::string_view source;
};

/// One row of the reference table: words that name blocks of certain sections.
struct ReferenceKind {
    std::string_view name;    ///< "contour block"
    SectionKind::Role target; ///< where the block must stand
    std::string_view source;
};

/// Limits of a control. Levels are counted below the main program.
struct Limits {
    int macro_calls;                         ///< nested macro calls; 0: there are none
    int subprogram_calls;                    ///< nested subprogram calls
    int loop_levels;                         ///< nested loops in one program; 0: no limit is known
    int first_loop_number, last_loop_number; ///< both 0: loops have no numbers, they pair by nesting
    int bracket_levels;                      ///< brackets in one expression, those of functions included
    std::string_view source;
};

/// The functions of the machine that words switch.
struct MachineFunctions {
    /// Numbers from the first to the last.
    struct Range {
        int first, last;
    };
    std::string_view address; ///< "M"
    /// Those which a parameter of the control lets stop look-ahead, beside those that the language says stop
    /// it. Nothing: nobody has said which, so any may.
    std::optional<std::vector<Range>> stopping = {};

    [[nodiscard]] bool may_stop_look_ahead(double number) const;
};

/// What a control drives: words such as G90 mean different things on the two.
enum class Machine : std::uint8_t { mill, lathe };

/// What the language of a control has, where rules speak of nothing else.
enum class Capability : std::uint8_t {
    loop_numbers,        ///< DO m … END m, which a number pairs
    sections,            ///< parts that words of their own begin
    exclusive_words,     ///< it is known which words exclude each other in a block
    vacancy,             ///< variables can hold vacant, which programs set and ask for
    unset_locals,        ///< local variables hold no number before something sets them
    undefined_variables, ///< variables have values that nothing has defined, beside those that were set
    jumps,               ///< programs jump to blocks
    sequence_numbers,    ///< programs name blocks by their numbers
    block_references,    ///< words name blocks of certain sections
    macro_calls,         ///< calls that count against a limit of their own
    modal_calls,         ///< programs called after every move or block
    named_arguments,     ///< what a call passes is read by names of its own
    suppression,         ///< programs switch off single block, feed hold, override
};

/// The analysis keeps a table with an entry for each space of a control: no control has more.
inline constexpr std::size_t most_spaces = 16;

/// Everything that the analysis knows about a control; built once, shared by all programs of that control.
struct ControlModel {
    std::string name;          ///< "fanuc-16i"; what --control takes
    std::string_view language; ///< programs call programs of the same language
    std::string_view model;    ///< "fanuc-16i" of a mill and of a lathe: a name in the manufacturer's list
    std::string description;   ///< "FANUC Series 16i/18i/21i"
    Machine machine = Machine::mill;
    const ControlModel* lathe = nullptr; ///< of a mill: the same control on a lathe, for texts that are
                                         ///< written for one; nullptr: there is none, or nobody wants it
    bool assumed;                 ///< nobody named the control: messages say that its limits are assumed
    std::string_view alarms;      ///< the list that numbers its alarms, as rules name it; empty: none known
    std::string_view return_word; ///< leads back to the caller: "M99"
    Limits limits;
    std::vector<VariableSpace> spaces;
    std::vector<VariableFamily> families;
    std::vector<ModalGroup> groups;
    std::vector<CallKind> calls;
    std::vector<Variable>
        formals; ///< local variables that an argument letter of a call reaches (specification I)
    std::vector<char> formal_letters = {}; ///< the letter of each; empty: their names hold it
    std::vector<std::array<Variable, 3>> series =
        {}; ///< those that the first, second … I, J and K of a call reach (specification II)
    bool vacant_equals_zero;           ///< whether EQ and NE take vacant for 0
    std::vector<Idle> idle = {};       ///< when nobody asks for a feed or speed
    ProgramNumbers macro_numbers = {}; ///< that a shop keeps for macros, and protects
    bool loops_left_by_jump = true; ///< a jump can leave a loop, so a condition that always holds is a custom
    MachineFunctions functions = {"M"};
    std::vector<SectionKind> sections = {}; ///< empty: programs have no sections
    std::vector<ReferenceKind> references = {};
    /// Addresses that a block may hold more than once, and those that it may where it calls a program.
    std::vector<std::string_view> repeatable = {}, repeatable_arguments = {};

    [[nodiscard]] bool has(Capability capability) const;
    /// The group of that role, or nothing.
    [[nodiscard]] std::optional<GroupId> group_with(ModalRole role) const;
    /// The group that a code of `letter` sets, or nothing.
    [[nodiscard]] std::optional<GroupId> group_of(char letter, double code) const;
    /// The letter of a call that reaches the variable; nothing where there is none.
    [[nodiscard]] std::optional<char> letter_of(Variable variable) const;
    /// The variable that reads the group, "#4109" for the feed; nothing where there is none.
    [[nodiscard]] std::optional<std::string> variable_of(GroupId group) const;
    /// The code as it is written: "G91", "G54.1".
    [[nodiscard]] std::string spell(GroupId group, double code) const;
};

/// The control, whose tables must be such that the analysis has room for them: std::logic_error else. What
/// builds a control gives it away through this.
[[nodiscard]] ControlModel checked(ControlModel control);

} // namespace maclint
