//! Codes of NCT mills, as far as pages of their manual are at hand.
#include "rules/words/cited_lines.hpp"

namespace maclint::code_books {
namespace {

using namespace book;
using enum Severity;
constexpr TableText of_nct = "NCT";
constexpr TableText axes = "X Y Z A B C U V W";
constexpr TableText end_point = "end point of a move that the code in force makes";
constexpr TableText arguments = "A B C D E F H I J K M Q R S T U V W X Y Z";

// Pages of the same manual name each word; an I between address and number makes it incremental.
// clang-format off
constexpr BookLine lines[] = {
    code("G10", "NCT-78", "change of tool compensations"),
        word("R", "NCT-78", "value; under G91 it is added"),
        word("L", "NCT-78", "kind of the compensation"),
        word("P", "NCT-78", "number of the compensation"),
        word(axes, "T", "values of a work offset"),
    code("G15", "NCT-40", "polar coordinates off"),
        word(axes, "NCT-40", end_point),
    code("G16", "T", "polar coordinates on"),
        word(axes, "T", "radius at the first axis, angle at the second"),
        word("R", "T", "radius of an arc"),
    code("G20 G21", "NCT-40", "lengths in inches, in millimetres"),
    code("G22", "NCT-161", "programmable stroke check on"),
        word("X Y Z", "NCT-161", "limit in the positive direction"),
        word("I J K", "NCT-161", "limit in the negative direction"),
        word("P", "NCT-161", "0 forbids the inside, 1 the outside", "0 1"),
    code("G23", "NCT-161", "programmable stroke check off"),
    code("G28", "NCT-52", "return to the reference point"),
        word(axes, "NCT-52", "intermediate point; the axes named return"),
    code("G29", "NCT-53", "return from the reference point"),
        word(axes, "NCT-53", "end point"),
    code("G30", "NCT-53", "return to reference point 1, 2, 3 or 4"),
        word("P", "NCT-53", "reference point", "1 2 3 4"),
        word(axes, "NCT-53", "intermediate point; the axes named return"),
        needs(axes, "NCT-53", "axes that return", "no axis moves"),
    code("G31", "NCT-159", "feed move that a signal ends, probing"),
        word(axes, "NCT-159", "end point where no signal comes"),
        word("F", "T", "feed").without("feed in force"),
        word("P Q R", "T", "further words"),
        refused_under("G41 G42", "NCT-159", "the control moves to a signal under G40 only").as(error).alarm(of_nct, "3054"),
        refused_under("G95", "NCT-159", "the control moves to a signal under a feed a minute only").as(error).alarm(of_nct, "3054"),
        refused_under("G51", "NCT-159", "the control takes no move to a signal under scaling").as(error).alarm(of_nct, "3054"),
        refused_under("G51.1", "NCT-159", "the control takes no move to a signal under mirror image").as(error).alarm(of_nct, "3054"),
        refused_under("G68", "NCT-159", "the control takes no move to a signal under rotation").as(error).alarm(of_nct, "3054"),
        refused_under("G16", "NCT-159", "the control takes no move to a signal under polar coordinates").as(error).alarm(of_nct, "3054"),
    code("G37", "NCT-159", "automatic measuring of a tool's length"),
        word(axes, "NCT-159", "expected position of the sensor, absolute"),
        word("F P Q R", "T", "further words"),
        needs(axes, "NCT-159", "expected position of the sensor", "there is no axis to measure in"),
    code("G40", "NCT-85", "cutter compensation off"),
        word(axes, "NCT-85", end_point),
        word("I J K", "T", "direction of the contour after the move"),
    code("G41 G42", "NCT-85", "cutter compensation: left, right of the contour"),
        word("D", "NCT-85", "compensation number; 0 is no compensation").without("compensation in force"),
        word(axes, "NCT-102", end_point),
        word("I J K", "T", "direction of the contour"),
        word("E P R", "T", "further words"),
    code("G50", "NCT-117", "scaling off"),
        word(axes, "NCT-117", end_point),
    code("G51", "NCT-117", "scaling on"),
        word("X Y Z", "NCT-117", "centre"),
        word("P", "NCT-117", "factor"),
        word("I J K", "T", "further words"),
    code("G50.1", "NCT-117", "mirror image off"),
        word(axes, "NCT-117", "axes that are no longer mirrored"),
        needs(axes, "NCT-117", "axes that are no longer mirrored", "the mirror image stays"),
    code("G51.1", "NCT-117", "mirror image on"),
        word(axes, "NCT-117", "axis to mirror, and the place of the mirror"),
        needs(axes, "NCT-117", "axis to mirror", "nothing is mirrored"),
    code("G65 G66 G66.1", "NCT-171", "macro call: once, after each move, after each block"),
        word("P", "NCT-171", "program to call"),
        word("L", "NCT-171", "number of repeats"),
        word(arguments, "NCT-171", "arguments"),
    code("G67", "NCT-171", "end of the last G66 or G66.1"),
    code("G68", "NCT-114", "rotation"),
        word("X Y Z", "NCT-114", "centre in the plane").without("present position"),
        word("R", "NCT-114", "angle in degrees; under G91 it is added"),
    code("G69", "NCT-114", "rotation off"),
        word(axes, "NCT-114", end_point),
};
// clang-format on

} // namespace

extern const CodeBook nct_mill{.language = "fanuc",
                               .chapter = "codes of NCT mills",
                               .source = "T",
                               .sections = "",
                               .machine = Machine::mill,
                               .controls = "nct",
                               .partial = true,
                               .lines = lines};

} // namespace maclint::code_books
