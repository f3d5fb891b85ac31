//! Which words move the axes of mills and of lathes, and choose tools and offsets.
#include "analyzer/dialect/fanuc/tables.hpp"

#include <array>

namespace maclint::fanuc {
namespace {

// M00 to M02, M30: stops and ends; M06: change; M07 to M09: coolant; M48, M49: overrides; M98, M99: calls.
constexpr std::array<double, 12> aside = {0, 1, 2, 6, 7, 8, 9, 30, 48, 49, 98, 99};
constexpr std::array<double, 4> resetting = {52, 50.3, 92.1, 10};
constexpr std::array<double, 5> mill_resetting = {52, 92, 92.1, 10, 51};
constexpr std::array<double, 2> of_machine = {53, 53.1};
constexpr std::array<double, 1> clamping_of_mills = {92};
constexpr std::array<double, 1> clamping_of_a = {50};
constexpr std::array<double, 7> returning = {70, 71, 72, 73, 74, 75, 76};
constexpr std::array<double, 7> returning_in_c = {72, 73, 74, 75, 76, 77, 78};
constexpr std::array<double, 3> passes_in_a = {90, 92, 94};
constexpr std::array<double, 3> passes_in_b = {77, 78, 79};
constexpr std::array<double, 3> passes_in_c = {20, 21, 24};
constexpr std::array<double, 6> tapping_cycles = {74, 84, 84.2, 84.3, 88, 184};
constexpr std::array<double, 6> threads = {32, 33, 34, 76, 78, 92};
constexpr std::array<double, 1> threads_of_mills = {33};
constexpr double rigid_tapping = 29;
constexpr double hundredth = 0.02;

constexpr std::string_view source =
    "the word tables of the custom macro reference; T: functions of the machine";

constexpr MachineWords mill = {.axes = {'X', 'Y', 'Z'},
                               .centres = {'I', 'J', 'K'},
                               .length_offset = 'H',
                               .cutter_offset = 'D',
                               .change_stops_spindle = true,
                               .rigid_tapping = rigid_tapping,
                               .tapping_cycles = tapping_cycles,
                               .threads = threads_of_mills,
                               .resetting = mill_resetting,
                               .of_machine = of_machine,
                               .clamping = clamping_of_mills,
                               .aside = aside,
                               .circle_tolerance = hundredth,
                               .source = source};

constexpr MachineWords lathe(AxisLetters increments, double feed_per_revolution,
                             std::span<const double> passes, std::span<const double> cycles,
                             std::span<const double> clamping) {
    return {.axes = {'X', 'Y', 'Z'},
            .increments = increments,
            .centres = {'I', 'J', 'K'},
            .x_is_diameter = true,
            .tool_word_holds_offset = true,
            .feed_per_revolution = feed_per_revolution,
            .rigid_tapping = rigid_tapping,
            .tapping_cycles = tapping_cycles,
            .threads = threads,
            .passes = passes,
            .returning = cycles,
            .resetting = resetting,
            .of_machine = of_machine,
            .clamping = clamping,
            .aside = aside,
            .circle_tolerance = hundredth,
            .source = source};
}

constexpr AxisLetters u_and_w = {'U', 0, 'W'};
constexpr MachineWords lathe_a = lathe(u_and_w, 99, passes_in_a, returning, clamping_of_a);
constexpr MachineWords lathe_b = lathe({}, 95, passes_in_b, returning, clamping_of_mills);
constexpr MachineWords lathe_c = lathe({}, 95, passes_in_c, returning_in_c, clamping_of_mills);

} // namespace

const MachineWords& machine_words(char system) {
    switch (system) {
    case 'A': return lathe_a;
    case 'B': return lathe_b;
    case 'C': return lathe_c;
    default: return mill;
    }
}

} // namespace maclint::fanuc
