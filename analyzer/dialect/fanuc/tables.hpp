//! The controls of the Fanuc family: limits, variables, modal groups and calls.
#pragma once

#include "analyzer/program/machine_words.hpp"
#include "analyzer/program/syntax_error.hpp"
#include "analyzer/program/tables.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace maclint::fanuc {

/// Rows of ControlModel::spaces.
namespace spaces {
constexpr SpaceId local = 0, common = 1, retained = 2, machine = 3, named = 4;
}

/// The only family: the number after `#`.
constexpr FamilyId numbered = 0;

/// Rows of ControlModel::calls.
namespace calls {
constexpr CallKindId g65 = 0, g66 = 1, g66_1 = 2, m98 = 3, m198 = 4;
}

[[nodiscard]] std::vector<ModalGroup> mill_groups();
/// Of G code system 'A', 'B' or 'C'.
[[nodiscard]] std::vector<ModalGroup> lathe_groups(char system);
/// When feed and speed matter to no move.
/// Of a mill (0), or a lathe with that system of G codes.
[[nodiscard]] const MachineWords& machine_words(char system);
[[nodiscard]] std::span<const Switch> switch_rows();
[[nodiscard]] std::vector<Idle> idle_values(std::span<const ModalGroup> groups);
[[nodiscard]] std::vector<VariableSpace> variable_spaces();
/// What `#n` is; `groups` gives the rows that #4001 and the like read.
/// `group_twelve` is the row that #4012 reads, where that is known; `model` names the control, which may have
/// numbers of its own.
[[nodiscard]] VariableFamily numbered_variables(std::span<const ModalGroup> groups,
                                                std::optional<GroupId> group_twelve, std::string_view model);

// Argument specification I, fanuc-custom-macro.md 5.2: the local variable of each letter from A to Z, 0 for
// none.
// clang-format off
//                                                     A  B  C  D  E  F  G  H   I  J  K  L  M   N  O  P  Q   R   S   T   U   V   W   X   Y   Z
constexpr std::array<std::int32_t, 26> local_of_letter{1, 2, 3, 7, 8, 9, 0, 11, 4, 5, 6, 0, 13, 0, 0, 0, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26};
// clang-format on

/// Of the controls of the model; empty: nobody has told.
[[nodiscard]] std::span<const ControlOption> options_of(std::string_view model);

/// All controls of the family.
[[nodiscard]] std::span<const ControlModel> fanuc_controls();
/// The control of that name, which must exist.
[[nodiscard]] const ControlModel& fanuc_control(std::string_view name);

/// Whether `M98 P51002` means five times O1002 (program numbers of four digits).
[[nodiscard]] bool program_word_holds_repeats(const ControlModel& control);
/// Whether `#30003.036` is a variable.
[[nodiscard]] bool has_variables_with_decimals(const ControlModel& control);
/// Whether an I between address and value makes it incremental: `ZI5`.
[[nodiscard]] bool has_incremental_words(const ControlModel& control);
/// Whether `M99 P10` goes to N10 of its own program, and to none of a caller.
[[nodiscard]] bool return_jumps_in_program(const ControlModel& control);
/// "nct"
[[nodiscard]] std::string controls_with_incremental_words();

/// What a control makes of a way of writing that not every control of the family takes.
enum class Reading : std::uint8_t {
    takes,
    stops,
    unknown,  ///< no document tells
    doubtful, ///< no document tells, and it can hardly be meant
};
/// `form` is one that stands in the table of forms.
[[nodiscard]] Reading reading_of(const ControlModel& control, SyntaxErrorKind form);
/// Of text that the parser takes; `fault` is one of `faults`.
[[nodiscard]] Reading reading_of(const ControlModel& control, std::string_view fault);
/// Of a program number behind the end of the program before it: `M99O0810`, `M99 O0810`.
[[nodiscard]] Reading program_behind_end(const ControlModel& control);
/// "haas": the controls that take the form, for the text of a message; empty: none.
[[nodiscard]] std::string controls_that_take(SyntaxErrorKind form);

} // namespace maclint::fanuc
