//! Machine functions that Haas mills and lathes share.
#include "rules/words/cited_lines.hpp"

namespace maclint::code_books {
namespace {

using namespace book;
using enum Severity;

// clang-format off
constexpr BookLine lines[] = {
    code("M0", "H07:91", "program stop"),
    code("M1", "H07:91", "optional stop"),
    code("M2", "T", "end of the program"),
    code("M3 M4", "HSCHOOL", "spindle on, clockwise (M3) or counter-clockwise (M4)"),
        word("S", "HSCHOOL", "spindle speed").without("speed in force"),
        word("P R", "T", "values of other spindles"),
    code("M5", "HSCHOOL", "spindle stop"),
    code("M8 M9", "HSCHOOL", "coolant on (M8), off (M9)"),
        word("P", "T", "nozzle or position"),
    code("M19", "T", "spindle orientation"),
        word("P", "T", "angle in whole degrees").without("0"),
        word("R", "T", "angle in degrees, with a point"),
        word("S", "T", "spindle speed"),
        excludes("P", "R", "T", "only one of the two angles counts"),
    code("M29", "T", "output on, until the machine answers"),
        word("P", "T", "number of the output").needed("nothing says which output is meant"),
    code("M30", "H10:217", "end of the program, back to its start"),
    code("M31 M33", "T", "chip conveyor on (M31), off (M33)"),
    code("M32", "T", "chip conveyor backwards"),
    code("M41 M42", "T", "low gear (M41) or high gear (M42)"),
    code("M51 M52 M53 M54 M55 M56 M57 M58", "T", "output of the shop on, 1 (M51) to 8 (M58)"),
    code("M59 M69", "T", "output on (M59), off (M69)"),
        word("P", "T", "number of the output").needed("nothing says which output is meant"),
    code("M61 M62 M63 M64 M65 M66 M67 M68", "T", "output of the shop off, 1 (M61) to 8 (M68)"),
    code("M70", "T", "work clamped by the electric vise"),
        word("P Q R", "T", "number of the vise"),
    code("M71", "T", "work released by the electric vise"),
        word("P Q R", "T", "number of the vise"),
    code("M76 M77", "T", "display of the program off (M76), on (M77)"),
    code("M78", "H99:169", "alarm where the probe has touched"),
    code("M79", "H99:169", "alarm where the probe has not touched"),
    code("M88 M89", "T", "high-pressure coolant on (M88), off (M89)"),
        word("P", "T", "pressure"),
    code("M95", "T", "sleep, with the time in a remark: (05:30)"),
    code("M96", "H10:217", "jump where an input is 0").in_calls(),
        word("P", "H10:217", "number of the block to go on at").needed("nothing says where to go on"),
        word("Q", "H10:217", "number of the input").needed("nothing says which input is asked"),
    code("M97", "H10:217", "call of blocks of this program").in_calls(),
        word("P", "H10:217", "number of the first block").required("nothing says which blocks are called"),
        word("L", "H10:217", "number of repeats").without("1"),
    code("M98", "H10:217", "subprogram call").in_calls(),
        word("P", "H10:217", "number of the program").without("its file, in a remark"),
        word("L", "H10:217", "number of repeats").without("1"),
    code("M99", "HCAMV", "return, or back to the start of a main program"),
        word("P", "HCAMV", "number of the block to go on at"),
    code("M109", "H07:91", "question to the operator, its text in a remark"),
        word("P", "H07:91", "number of the variable for the answer").needed("the answer is kept nowhere"),
    code("M121 M122 M123 M124 M125 M126 M127 M128", "T", "output of the shop, until the machine answers"),
    code("M129", "T", "output on, until the machine answers"),
        word("P", "T", "number of the output").needed("nothing says which output is meant"),
    code("M130 M131", "T", "picture or film on (M130), off (M131)"),
    code("M138 M139", "T", "variation of the spindle speed on (M138), off (M139)"),
    code("M158 M159", "T", "mist collector on (M158), off (M159)"),
    code("M180 M181", "T", "automatic window open (M180), closed (M181)"),
    code("M199", "T", "loading of a part or pallet, or end of the program"),
    code("M299", "T", "loading of a part or pallet, or end of the program"),
    code("M300", "T", "sequence of a parts loader or robot"),
        word("P", "T", "number of the sequence"),
        word("Q R I J K L", "T", "values that nobody has described"),
};
// clang-format on

} // namespace

extern const CodeBook haas_functions{.language = "fanuc",
                                     .chapter = "machine functions of Haas machines",
                                     .source = "T",
                                     .sections = "",
                                     .controls = "haas haas-1999",
                                     .lines = lines};

} // namespace maclint::code_books
