//! Which words move the axes, and what the machine's functions do.
#include "analyzer/dialect/sinumerik/tables.hpp"
#include "analyzer/program/machine_words.hpp"

#include <array>
#include <string_view>

namespace maclint::sinumerik {
namespace {

// M0, M1: stops; M2, M17, M30: ends; M6: change; M7 to M9: coolant. All others are the machine's maker's, but
// for the spindle's.
constexpr std::array<double, 9> aside = {0, 1, 2, 6, 7, 8, 9, 17, 30};
constexpr std::array<double, 2> coolant = {7, 8};
constexpr std::array<double, 4> of_machine = {53, 153, 74, 75};
constexpr std::array<double, 5> threads = {10, 11, 12, 16, 17}; ///< members: G33, G331, G332, G34, G35
// Poles and angles, also that of an arc from its start to its end; POS moves an axis by itself.
constexpr std::array<std::string_view, 6> other_targets = {"AP", "RP", "ANG", "AR", "POS", "POSA"};
constexpr std::array<double, 2> resetting = {74, 75}; ///< to the reference point, to a fixed point
constexpr std::array<double, 1> clamping = {26};      ///< G26 S2000
constexpr double surface_speed = 4;                   ///< member of its group: G96
constexpr double rapid = 1, absolute = 1;             ///< members of their groups: G0, G90

constexpr MachineWords words = {.axes = {'X', 'Y', 'Z'},
                                .centres = {'I', 'J', 'K'},
                                .radius_address = "CR",
                                .other_targets = other_targets,
                                .diameter_by_code = true,
                                .lengths_without_point = true,
                                .rapid = rapid,
                                .absolute = absolute,
                                .threads = threads,
                                .resetting = resetting,
                                .of_machine = of_machine,
                                .clamping = clamping,
                                .surface_speed = surface_speed,
                                .speed_mode = ModalRole::feed_mode,
                                .clamp_address = "LIMS",
                                .side_by_off = true, // SEED-004:242
                                .aside = aside,
                                .coolant_on = coolant,
                                .circle_tolerance = 0.02,
                                .source = "SEED-004:137-440; T: functions of the machine"};

} // namespace

const MachineWords& machine_words() { return words; }

} // namespace maclint::sinumerik
