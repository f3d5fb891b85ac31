//! Machine functions of Haas lathes alone.
#include "rules/words/cited_lines.hpp"

namespace maclint::code_books {
namespace {

using namespace book;

// clang-format off
constexpr BookLine lines[] = {
    code("M6", "T", "tool change of lathes without a turret"),
        word("T", "T", "tool"),
    code("M7", "T", "shower coolant on"),
    code("M10 M11", "T", "chuck closed (M10), open (M11)"),
    code("M12 M13", "T", "air jet on (M12), off (M13)"),
        word("P", "T", "time"),
    code("M14 M15", "T", "spindle brake on (M14), off (M15)"),
    code("M17 M18", "T", "turret turns forward (M17), backward (M18) to the next tool"),
        word("T", "T", "tool"),
    code("M21 M22", "T", "tailstock forward (M21), back (M22)"),
    code("M23 M24", "HDIY:g76-threading-cycle-multiple-pass", "chamfer at the end of threads on (M23), off (M24)"),
    code("M25 M26 M27 M28", "T", "output of the shop, until the machine answers"),
    code("M36 M37", "T", "parts catcher out (M36), back (M37)"),
    code("M38 M39", "T", "variation of the spindle speed on (M38), off (M39)"),
        word("P", "T", "time of a cycle"),
        word("R", "T", "size of the variation"),
    code("M43 M44", "T", "turret released (M43), clamped (M44)"),
    code("M85 M86", "T", "automatic door open (M85), closed (M86)"),
    code("M93 M94", "T", "recording of axis positions on (M93), off (M94)"),
        word("P Q R", "T", "values that nobody has described"),
    code("M104 M105", "T", "probe arm out (M104), in (M105)"),
    code("M110 M111", "T", "chuck of the second spindle closed (M110), open (M111)"),
    code("M112 M113", "T", "air jet of the second spindle on (M112), off (M113)"),
    code("M114 M115", "T", "brake of the second spindle on (M114), off (M115)"),
    code("M119", "T", "orientation of the second spindle"),
        word("P", "T", "angle in whole degrees").without("0"),
        word("R", "T", "angle in degrees, with a point"),
        excludes("P", "R", "T", "only one of the two angles counts"),
    code("M133 M134", "T", "live tool on, clockwise (M133) or counter-clockwise (M134)"),
        word("P", "T", "speed of the live tool"),
    code("M135", "T", "live tool stop"),
    code("M143 M144", "T", "second spindle on, clockwise (M143) or not (M144)"),
        word("P", "T", "speed of the second spindle"),
    code("M145", "T", "second spindle stop"),
    code("M146 M147", "T", "steady rest closed (M146), open (M147)"),
    code("M154 M155", "T", "C axis on (M154), off (M155)"),
    code("M164", "T", "parts loader: turn of the gripper"),
        word("P", "T", "number of the gripper"),
    code("M170 M171", "T", "brake of an axis on (M170), off (M171)"),
    code("M219", "T", "orientation of the live tool"),
        word("P", "T", "angle in whole degrees").without("0"),
        word("R", "T", "angle in degrees, with a point"),
        excludes("P", "R", "T", "only one of the two angles counts"),
};
// clang-format on

} // namespace

extern const CodeBook haas_lathe_functions{.language = "fanuc",
                                           .chapter = "machine functions of Haas lathes",
                                           .source = "T",
                                           .sections = "",
                                           .machine = Machine::lathe,
                                           .controls = "haas haas-1999",
                                           .lines = lines};

} // namespace maclint::code_books
