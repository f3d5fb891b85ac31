//! DIN PLUS: M functions. Numbers are lines of the manual.
#include "rules/words/code_book.hpp"

namespace maclint::code_books {
namespace {

using namespace book;
using enum Severity;

// clang-format off
constexpr BookLine lines[] = {
    code("M0", 20013, "program stop"),
    code("M1", 20014, "optional stop"),
    code("M3", 20039, "main spindle on, clockwise"),
    code("M4", 20040, "main spindle on, counterclockwise"),
    code("M5", 20041, "main spindle stop"),
    code("M8", 1863, "coolant circuit 1 on"),
    code("M9", 1880, "all coolant circuits off"),
    code("M12", 20042, "main spindle brake clamp"),
    code("M13", 20043, "main spindle brake release"),
    code("M14", 20044, "C axis on"),
    code("M15", 20045, "C axis off"),
    code("M18", 20015, "counting pulse"),
    code("M19", 20046, "spindle stop at angle C"),
        word("C", 20046, "spindle stop position").without("table names a position C, prints no word in the code column"),
    code("M30", 20016, "end of program"),
    code("M40", 20047, "shift gear to range 0"),
    code("M41", 20048, "shift gear to range 1"),
    code("M42", 20049, "shift gear to range 2"),
    code("M43", 20050, "shift gear to range 3"),
    code("M44", 20051, "shift gear to range 4"),
    code("M91", 20017, "stop without spindle stop"),
    code("M97", 20018, "synchronous function"),
        word("H", 20192, "synchronous mark number").without("no number"),
        word("Q", 20193, "slides waited for, one digit each").without("the slides of the $ code of the block"),
        word("D", 20194, "0 at run time, 1 during interpretation", "0 1").without("0 or 1 not printed as default"),
    code("M99", 20021, "end of program with restart"),
        word("NS", 20021, "block to restart from").without("restart from the beginning of the program"),
    code("M103", 20052, "spindle 1 on, clockwise"),
    code("M104", 20053, "spindle 1 on, counterclockwise"),
    code("M105", 20054, "spindle 1 stop"),
    code("M107", 20939, "not described"),
    code("M108", 14774, "not described"),
    code("M109", 14779, "not described"),
    code("M203", 20052, "spindle 2 on, clockwise"),
    code("M204", 20053, "spindle 2 on, counterclockwise"),
    code("M205", 20054, "spindle 2 stop"),
    code("M303", 20052, "spindle 3 on, clockwise"),
    code("M304", 20053, "spindle 3 on, counterclockwise"),
    code("M305", 20054, "spindle 3 stop"),
    code("M315", 8489, "C axis off"),
    code("M417", 20019, "activate protection zone"),
    code("M418", 20020, "deactivate protection zone"),
};
// clang-format on

} // namespace

extern const CodeBook dinplus_m_functions{.language = "dinplus",
                                          .chapter = "M functions",
                                          .source = "SEED-003",
                                          .sections = "MACHINING SUBPROGRAM",
                                          .lines = lines};

} // namespace maclint::code_books
