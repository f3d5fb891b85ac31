//! SINUMERIK 840D sl, 828D, 808D and ONE: variables, modal groups and calls, as rows of facts. Keys of
//! sources are those of docs/sources.md.
#pragma once

#include "analyzer/program/tables.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace maclint::sinumerik {

/// Rows of ControlModel::spaces.
namespace spaces {
constexpr SpaceId r = 0, local = 1, parameter = 2, machine = 3;
} // namespace spaces

/// Rows of ControlModel::families.
namespace families {
constexpr FamilyId r = 0, ///< R[…]
    system = 1;           ///< what the control or its maker owns
} // namespace families

/// Rows of ControlModel::calls.
namespace calls {
constexpr CallKindId by_name = 0, cycle = 1, modal = 2;
} // namespace calls

/// What a written code sets, with or without a number: "G18", "DIAMON". The group is a row of
/// ControlModel::groups.
struct SettingOfCode {
    std::optional<GroupCode> sets; ///< nothing: the code acts in its block alone
    bool moves = false;            ///< axes move without a word of theirs
    bool takes_axes = false;       ///< words of axes beside it are no target of a move
};
/// Nothing for a code of no group.
[[nodiscard]] std::optional<SettingOfCode> setting_of(std::string_view capitals);

/// G290 and G291: the blocks between them are of another language [T].
[[nodiscard]] constexpr bool switches_language(std::size_t code) {
    constexpr std::size_t own = 290, foreign = 291;
    return code == own || code == foreign;
}

/// Functions of the machine that the analysis depends on: M0 and M1 wait, M2, M30 and M17 end a program
/// [NCP19 p.45], M6 changes the tool where the machine's maker has not chosen another [SEED-004:246].
namespace functions {
constexpr double program_stop = 0, optional_stop = 1, end = 2, end_and_back = 30, end_of_subprogram = 17,
                 tool_change = 6;
} // namespace functions
[[nodiscard]] constexpr bool acts_on_flow(double number) {
    return number == functions::program_stop || number == functions::optional_stop ||
           number == functions::end || number == functions::end_and_back ||
           number == functions::end_of_subprogram || number == functions::tool_change;
}

/// The row of ControlModel::groups for a G group of the language; nothing where it is not modal.
[[nodiscard]] std::optional<GroupId> row_of_g_group(std::int64_t group);
/// A code that writes a part of the programmable frame: "ATRANS".
struct FrameCode {
    GroupId group;
    bool replaces; ///< and takes back all other parts; alone in its block, its own, too
};
[[nodiscard]] std::optional<FrameCode> frame_code(std::string_view capitals);
/// The groups of all parts of the programmable frame, each 0 or 1.
[[nodiscard]] std::vector<GroupId> frame_groups();
/// What a procedure switches on or off: TRANSMIT, TRAFOOF; nothing for others.
[[nodiscard]] std::optional<GroupCode> coupling_code(std::string_view procedure);
/// Whether PROC … SAVE keeps the group for the caller: the G codes and the frame [BF11 p.793].
[[nodiscard]] bool is_put_back_by_save(GroupId group);
/// "MCALL", on and off.
[[nodiscard]] GroupId modal_call_group();

/// Which words move the axes.
[[nodiscard]] const MachineWords& machine_words();

/// "sinumerik", of which nobody has said what machine it is at, and those with the codes of a mill or of a
/// lathe in force when a program begins.
[[nodiscard]] std::span<const ControlModel> controls();
/// "sinumerik": groups, calls and variables are the same in all.
[[nodiscard]] const ControlModel& control();

} // namespace maclint::sinumerik
