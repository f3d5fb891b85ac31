//! Machine functions of Fanuc mills and lathes.
#include "rules/words/cited_lines.hpp"

namespace maclint::code_books {
namespace {

using namespace book;
constexpr TableText of_16i = "FANUC 16i/18i/21i", of_30i = "FANUC 30i/0i-D";
constexpr TableText builders = "P Q R L I J K";
constexpr TableText of_the_builder = "values for the machine's own function";
constexpr TableText beside_call = "words of the block, no arguments";
constexpr TableText stops_with_speed = "the program stops with a new speed: M3 or M4 may be meant";

// Most numbers are the machine builder's; only those have a page here whose meaning is the same on nearly all
// machines.
// clang-format off
constexpr BookLine lines[] = {
    code("M0", "T", "program stop"),
        takes_not("S", "T", stops_with_speed),
    code("M1", "T", "program stop where the operator has chosen it"),
        takes_not("S", "T", stops_with_speed),
    code("M2", "T", "end of program"),
    code("M3 M4", "T", "spindle on: clockwise, counter-clockwise"),
        word("S", "T", "spindle speed").without("speed in force"),
        word("P", "T", "spindle, of machines with several"),
        word("R Q", "T", of_the_builder),
    code("M5", "T", "spindle off"),
        word("P", "T", "spindle, of machines with several"),
        word("R Q", "T", of_the_builder),
    code("M6", "GH-ALM", "tool change"),
        word("T", "GH-ALM", "tool").without("tool chosen before"),
        word(builders, "T", of_the_builder),
    code("M7", "T", "coolant or mist on"),
    code("M8", "T", "coolant on"),
    code("M9", "T", "coolant off"),
    code("M10 M11", "T", "clamp, unclamp: the machine builder's choice"),
        word(builders, "T", of_the_builder),
    code("M19", "T", "spindle stopped at an angle"),
        word("S R P Q", "T", "angle, spindle"),
        word("I J K L", "T", of_the_builder),
    code("M29", "GH-ALM", "rigid tapping in the G84 or G74 that follows"),
        word("S", "GH-ALM", "spindle speed").without("speed in force"),
        word(builders, "T", of_the_builder),
    code("M30", "T", "end of program, back to its start"),
    code("M41 M42 M43 M44", "T", "gear: the machine builder's choice"),
        word(builders, "T", of_the_builder),
    code("M48", "SWANSC", "override of feed in effect again"),
    code("M49", "SWANSC", "override of feed without effect"),
    code("M60", "SWANSC", "pallet change: the machine builder's choice"),
        word(builders, "T", of_the_builder),
    code("M96", "T", "interruption by a macro from here on (option)").in_calls(),
        word("P", "T", "program of the interruption"),
        word("L", "T", "number of repeats"),
        word("Q R", "T", of_the_builder),
    code("M97", "T", "interruption by a macro no longer (option)").in_calls(),
    code("M98", "GTUTOR", "subprogram call").in_calls(),
        word("P", "GTUTOR", "program to call, repeats in front of four digits").without("present program, beside Q"),
        word("L", "GTUTOR", "number of repeats").without("1"),
        word("Q", "T", "block number where the called program starts"),
        whole("P L", "CSDN-PS", "the control stops").in_calls().alarm(of_16i, "007").alarm(of_30i, "007"),
        word("I J K R", "T", beside_call),
    code("M99", "SEED-001:642", "end of a subprogram; of a main program its repeat"),
        word("P", "SEED-001:642", "block to go on with, of the caller or main program"),
        word("L", "T", "number of the repeats from then on"),
        word("Q R", "T", of_the_builder),
    code("M198", "CNCWIKI-SUB", "call of a subprogram on another device (option)").in_calls(),
        word("P", "CNCWIKI-SUB", "program or file to call"),
        word("L", "T", "number of repeats").without("1"),
        word("Q I J K R", "T", beside_call),
};
// clang-format on

} // namespace

extern const CodeBook fanuc_functions{.language = "fanuc",
                                      .chapter = "machine functions",
                                      .source = "T",
                                      .sections = "",
                                      .controls = "fanuc fanuc-16i fanuc-0i-c fanuc-0i-d fanuc-30i",
                                      .lines = lines};

} // namespace maclint::code_books
