//! Which words of a control move its axes, choose its tools and its offsets.
#pragma once

#include "analyzer/program/modal_groups.hpp"

#include <array>
#include <cstddef>
#include <span>
#include <string_view>

namespace maclint {

/// The letters of the three axes that circles lie in: X, Y and Z; 0: there is none.
using AxisLetters = std::array<char, 3>;

/// Letters that name axes, whichever of them a machine has; those of them along which it measures lengths.
inline constexpr std::string_view letters_of_axes = "XYZABCUVW", letters_of_lengths = "XYZUVW";

/// Rows about one kind of machine.
struct MachineWords {
    AxisLetters axes;
    AxisLetters increments = {}; ///< count from where the tool is, whatever the distance mode
    AxisLetters centres;         ///< of a circle, from its start: I, J and K
    char radius = 'R';
    /// How the radius is written where its address has several letters: "CR"; it counts as `radius`.
    std::string_view radius_address = {};
    /// Words of several letters that say where a move ends: AP, RP.
    std::span<const std::string_view> other_targets = {};
    /// Codes say whether X counts diameters: of circles that X lies in with Z or Y, no radius is known.
    bool diameter_by_code = false;
    bool lengths_without_point = false; ///< a number without a point is a length, and counts no thousandths
    char tool = 'T';
    char length_offset = 0; ///< 0: the tool's word names it
    char cutter_offset = 0;
    bool x_is_diameter = false;
    bool tool_word_holds_offset = false; ///< T0203 is tool 2 with offset 3
    bool change_stops_spindle = false;   ///< whoever changes the tool has the spindle stopped
    double rapid = 0;                    ///< code of the motion mode
    double absolute = 90;                ///< code of the distance mode, where there is one
    double to_start = 98, to_level = 99; ///< codes of the return level: where a canned cycle leaves the tool
    double feed_per_revolution = 95;     ///< code of the feed mode
    double rigid_tapping = -1;           ///< function of the machine; -1: it has none
    std::span<const double> tapping_cycles = {}; ///< they turn the spindle themselves
    std::span<const double> threads = {};        ///< G codes whose F is a lead
    /// Codes of the motion mode under which each move is a pass that ends where it began.
    std::span<const double> passes = {};
    /// G codes: of cycles that end where they began, of positions that count from elsewhere behind them, of
    /// moves in the machine's own coordinates, and those whose S is the highest speed.
    std::span<const double> returning = {}, resetting = {}, of_machine = {}, clamping = {};
    double surface_speed = 96;                    ///< code of the speed mode
    ModalRole speed_mode = ModalRole::speed_mode; ///< the group that surface speed belongs to
    std::string_view clamp_address = {};          ///< of the highest speed, where a word gives it: "LIMS"
    bool side_by_off = false;      ///< the side of cutter compensation changes only where it was off between
    double feed_per_minute = 94;   ///< code of the feed mode
    double inch = 20, metric = 21; ///< codes of the units
    /// G codes of cycles that read a profile behind them, and end where they began.
    std::span<const double> roughing = {};
    /// G codes of holes along Z, and those among them that are holes only where the block has no X.
    std::span<const double> holes = {}, holes_without_x = {};
    /// Machine functions that leave the spindle as it is. Any other may do anything with it.
    std::span<const double> aside = {};
    /// Machine functions that switch coolant on, and the one that switches all of it off.
    std::span<const double> coolant_on = {};
    double coolant_off = 9;
    /// So far the two ends of a circle may lie from one circle around its centre, in mm.
    double circle_tolerance = 0;
    /// G codes of moves that a signal ends, and those whose words are data for offsets and parameters.
    std::span<const double> skips = {}, settings = {};
    std::string_view source;
};

} // namespace maclint
