//! Which words move the axes of mills and of lathes, and choose tools and offsets.
#include "analyzer/dialect/fanuc/tables.hpp"

#include <array>

namespace maclint::fanuc {
namespace {

// M00 to M02, M30: stops and ends; M06: change; M07 to M09: coolant; M48, M49: overrides; M98, M99: calls.
constexpr std::array<double, 12> aside = {0, 1, 2, 6, 7, 8, 9, 30, 48, 49, 98, 99};
// M13 and M14 are M03 and M04 with coolant.
constexpr std::array<double, 4> coolant = {7, 8, 13, 14};
constexpr std::array<double, 4> resetting = {52, 50.3, 92.1, 10};
constexpr std::array<double, 5> mill_resetting = {52, 92, 92.1, 10, 51};
constexpr std::array<double, 2> of_machine = {53, 53.1};
constexpr std::array<double, 1> clamping_of_mills = {92};
// Some write G92 S of the other systems there, and have it taken.
constexpr std::array<double, 2> clamping_of_a = {50, 92};
constexpr std::array<double, 7> returning = {70, 71, 72, 73, 74, 75, 76};
constexpr std::array<double, 7> returning_in_c = {72, 73, 74, 75, 76, 77, 78};
constexpr std::array<double, 3> passes_in_a = {90, 92, 94};
constexpr std::array<double, 3> passes_in_b = {77, 78, 79};
constexpr std::array<double, 3> passes_in_c = {20, 21, 24};
constexpr std::array<double, 6> tapping_cycles = {74, 84, 84.2, 84.3, 88, 184};
constexpr std::array<double, 1> threads_of_mills = {33};
constexpr double rigid_tapping = 29;
constexpr std::array<double, 5> tapping_cycles_of_lathes = {84, 84.2, 84.3, 88, 88.2};
constexpr std::array<double, 3> roughing = {71, 72, 73};
constexpr std::array<double, 3> roughing_in_c = {73, 74, 75};
constexpr std::array<double, 6> threads_in_a = {32, 34, 35, 36, 76, 92};
constexpr std::array<double, 6> threads_in_b = {33, 34, 35, 36, 76, 78};
constexpr std::array<double, 6> threads_in_c = {33, 34, 35, 36, 78, 21};
constexpr std::array<double, 7> holes = {74, 81, 82, 83, 83.1, 84, 85};
constexpr std::array<double, 7> holes_in_c = {76, 81, 82, 83, 83.1, 84, 85};
constexpr std::array<double, 1> pecking = {74};
constexpr std::array<double, 1> pecking_in_c = {76};
constexpr std::array<double, 5> skips = {31, 31.1, 31.2, 31.3, 31.4};
constexpr std::array<double, 1> settings = {10};
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
                               .coolant_on = coolant,
                               .circle_tolerance = hundredth,
                               .skips = skips,
                               .settings = settings,
                               .source = source};

constexpr MachineWords lathe() {
    return {.axes = {'X', 'Y', 'Z'},
            .centres = {'I', 'J', 'K'},
            .x_is_diameter = true,
            .tool_word_holds_offset = true,
            .rigid_tapping = rigid_tapping,
            .tapping_cycles = tapping_cycles_of_lathes,
            .resetting = resetting,
            .of_machine = of_machine,
            .roughing = roughing,
            .holes = holes,
            .holes_without_x = pecking,
            .aside = aside,
            .coolant_on = coolant,
            .circle_tolerance = hundredth,
            .skips = skips,
            .settings = settings,
            .source = source};
}

constexpr MachineWords lathe_of_a() {
    MachineWords words = lathe();
    words.increments = {'U', 0, 'W'};
    words.passes = passes_in_a;
    words.returning = returning;
    words.clamping = clamping_of_a;
    words.feed_per_minute = 98;
    words.feed_per_revolution = 99;
    words.threads = threads_in_a;
    return words;
}

constexpr MachineWords lathe_of_b() {
    MachineWords words = lathe();
    words.passes = passes_in_b;
    words.returning = returning;
    words.clamping = clamping_of_mills;
    words.threads = threads_in_b;
    return words;
}

constexpr MachineWords lathe_of_c() {
    MachineWords words = lathe();
    words.passes = passes_in_c;
    words.returning = returning_in_c;
    words.clamping = clamping_of_mills;
    words.inch = 70;
    words.metric = 71;
    words.roughing = roughing_in_c;
    words.threads = threads_in_c;
    words.holes = holes_in_c;
    words.holes_without_x = pecking_in_c;
    return words;
}

constexpr MachineWords lathe_a = lathe_of_a(), lathe_b = lathe_of_b(), lathe_c = lathe_of_c();

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
