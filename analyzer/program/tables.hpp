//! What is known of a control, told to the analysis as data: the tables, whose rows have headers of their
//! own.
#pragma once

#include "analyzer/program/call_kinds.hpp"
#include "analyzer/program/capability.hpp"
#include "analyzer/program/ids.hpp"
#include "analyzer/program/label_search.hpp"
#include "analyzer/program/modal_groups.hpp"
#include "analyzer/program/region_kind.hpp"
#include "analyzer/program/section_kinds.hpp"
#include "analyzer/program/switches.hpp"
#include "analyzer/program/variable.hpp"
#include "analyzer/program/variable_tables.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace maclint {

struct MachineWords; // machine_words.hpp
struct ShopDemands;  // shop_demands.hpp

/// Numbers of programs, both included; none where `last` is 0.
struct ProgramNumbers {
    std::int64_t first = 0, last = 0;
    [[nodiscard]] constexpr bool contains(std::int64_t number) const {
        return last != 0 && first <= number && number <= last;
    }
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

/// Codes of which a block may hold one: they contradict each other.
struct ExclusiveCodes {
    std::string_view name; ///< "spindle 1"
    char letter;
    std::vector<double> codes;
    std::string_view source;
};

/// A code that the machine's maker or the shop has added.
struct OwnCode {
    char letter;
    double number;
    std::int64_t program = 0; ///< of the macro that it calls; 0: none, or nobody says
};

/// What a control has only where somebody has bought it.
struct ControlOption {
    std::string_view name;  ///< "scaling"; small letters, hyphens between words
    std::string_view codes; ///< that it brings, separated by blanks: "G50 G51"
    std::string_view what;  ///< "figures larger or smaller than they are written"
    char machines;          ///< 'M' of mills, 'T' of lathes, 'B' of both
    std::string_view source;

    [[nodiscard]] constexpr bool is_for(Machine machine) const {
        return machines == 'B' || (machines == 'M') == (machine == Machine::mill);
    }
};

/// What a control does with a block that holds an address twice, or two codes that contradict each other.
enum class Contradiction : std::uint8_t {
    last_counts, ///< it takes the last one, or stops, as a parameter says
    forbidden,   ///< the language has no such block
};

/// The words that open and close a construct: "FOR" and "ENDFOR".
struct RegionWords {
    RegionKind region_kind;
    std::string_view open, close;
};

/// The word of a jump that looks for its label in one direction: "GOTOF".
struct JumpWord {
    LabelSearch search;
    std::string_view word;
};

/// Everything that the analysis knows about a control; built once, shared by all programs of that control.
struct ControlModel {
    std::string name;          ///< "fanuc-16i"; what --control takes
    std::string_view language; ///< programs call programs of the same language
    std::string_view model;    ///< "fanuc-16i" of a mill and of a lathe: a name in the manufacturer's list
    std::string description;   ///< "FANUC Series 16i/18i/21i"
    Machine machine = Machine::mill;
    char code_system = 0; ///< of a lathe whose G codes come in systems: 'A', 'B', 'C'
    /// Of a mill: the same control on lathes, for texts that are written for one. Of a lathe, those whose
    /// system a text can show. Empty: there are none, or nobody wants them.
    std::vector<const ControlModel*> lathes = {};
    bool has_block_if = false; ///< IF … THEN opens blocks up to ELSE or ENDIF; if not, no text has them
    /// Constructs that pair by nesting, each with a word of its own that closes it; empty: numbers pair
    /// them, or the sections of the language have rules of their own for it.
    std::vector<RegionWords> region_words = {};
    std::vector<JumpWord> jump_words = {}; ///< empty: the word does not say the direction
    /// Codes of the rules that were held against programs of the language, sorted; empty: all that have what
    /// they need.
    std::span<const std::string_view> rules_tried = {};
    bool assumed;                 ///< nobody named the control: messages say that its limits are assumed
    std::string_view alarms;      ///< the list that numbers its alarms, as rules name it; empty: none known
    std::string_view return_word; ///< leads back to the caller: "M99"
    std::string_view end_word = "M30"; ///< ends the job
    /// Of an assumed control: those on which a return to a block (`M99 P10`) goes to one of its own program.
    std::string returns_within = {};
    Limits limits;
    /// Of an assumed control: the limits that no control which may be meant exceeds.
    std::optional<Limits> limits_at_most = {};
    std::vector<VariableSpace> spaces;
    std::vector<VariableFamily> families;
    std::vector<ModalGroup> groups;
    std::vector<EndedGroup> ended_groups = {}; ///< by codes of others: filled from `groups` by checked()
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
    Contradiction contradiction = Contradiction::last_counts;
    /// G codes from this number on may be the maker's or the shop's; 0: the language has them all.
    int first_free_code = 0;
    /// Those, where somebody has listed them: then there are no others of their letter. By letter, number.
    std::vector<OwnCode> own_codes = {};
    std::string letters_listed = {};             ///< "GM": the letters whose own codes are listed
    std::span<const ControlOption> options = {}; ///< of the control; which are fitted, nobody says
    std::string axes = {}; ///< letters of those that the machine has: "XYZA"; empty: nobody says
    /// Letters of arguments that are numbers of something, with a decimal point or without.
    std::string_view numbering_arguments = {};
    bool calculator_input =
        false; ///< a length without a point counts in millimetres or inches: X100 is X100.
    /// Where none names G codes, those of a modal group exclude each other.
    std::vector<ExclusiveCodes> exclusive_codes = {};
    /// Which words move its axes and choose its tools; nullptr: nobody has said it.
    const MachineWords* machine_words = nullptr;
    std::span<const Switch> switches = {}; ///< most_switches at most
    /// What the shop asks of programs for its machine; nullptr: nothing.
    std::shared_ptr<const ShopDemands> demands = nullptr;

    [[nodiscard]] bool has(Capability capability) const;
    /// The one of `lathes` with that system, or nullptr.
    [[nodiscard]] const ControlModel* lathe_of(char system) const;
    /// The group of that role, or nothing.
    [[nodiscard]] std::optional<GroupId> group_with(ModalRole role) const;
    /// What a code of `letter` sets its group to, or nothing.
    [[nodiscard]] std::optional<GroupCode> member_of(char letter, double code) const;
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
