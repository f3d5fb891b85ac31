//! DIN PLUS: M functions. Numbers are lines of the manual.
#include "rules/words/book_lines.hpp"
#include "rules/words/dinplus/common_lines.hpp"

namespace maclint::code_books {
namespace {

using namespace book;
using enum Severity;

constexpr TableText not_described = "the manual names it without saying what it takes";

// clang-format off
constexpr BookLine lines[] = {
    code("M0", 20013, "program stop"),
    code("M1", 20014, "optional stop"),
    code("M3", 20039, "main spindle on, clockwise"),
        not_as_c_axis, wants_speed,
    code("M4", 20040, "main spindle on, counterclockwise"),
        not_as_c_axis, wants_speed,
    code("M5", 20041, "main spindle off"),
    code("M8", 1863, "coolant circuit 1 on"),
    code("M9", 1880, "all coolant circuits off"),
    code("M12", 20042, "brake of the main spindle closed"),
    code("M13", 20043, "brake of the main spindle open"),
    code("M14", 20044, "C axis on"),
        left_on("C axis", 20045, "the next program turns no spindle").also("DIN653"),
        refused(18567, "there is no C axis in HDT mode").while_on("HDT mode").as(error).also("DIN915"),
    code("M15", 20045, "C axis off"),
    code("M18", 20015, "counting pulse"),
    code("M19", 20046, "spindle stop at an angle"),
        word("C", 20046, "angle of the spindle"),
    code("M30", 20016, "end of the program"),
    code("M40", 20047, "gear range 0, neutral"),
    code("M41", 20048, "gear range 1"),
    code("M42", 20049, "gear range 2"),
    code("M43", 20050, "gear range 3"),
    code("M44", 20051, "gear range 4"),
    code("M91", 20017, "stop without stopping the spindle"),
    code("M97", 20018, "synchronisation of slides"),
        word("H", 20192, "number of the mark").without("no number"),
        word("Q", 20193, "slides waited for, a digit each").without("slides of the $ code"),
        word("D", 20194, "waiting of 0 the run, 1 the interpretation", "0 1"),
    code("M99", 20021, "end of the program with restart"),
        word("NS", 20021, "block to go on from").without("beginning of the program"),
    code("M103", 20052, "spindle 1 on, clockwise"),
    code("M104", 20053, "spindle 1 on, counterclockwise"),
    code("M105", 20054, "spindle 1 off"),
    code("M107", 20939, "function of the machine, in examples alone").off(not_described),
    code("M108", 14774, "function of the machine, in examples alone").off(not_described),
    code("M109", 14779, "function of the machine, in examples alone").off(not_described),
    code("M203", 20052, "spindle 2 on, clockwise"),
    code("M204", 20053, "spindle 2 on, counterclockwise"),
    code("M205", 20054, "spindle 2 off"),
    code("M303", 20052, "spindle 3 on, clockwise"),
    code("M304", 20053, "spindle 3 on, counterclockwise"),
    code("M305", 20054, "spindle 3 off"),
    code("M315", 8489, "C axis of spindle 3 off").off(not_described),
    code("M417", 20019, "protection zone on"),
    code("M418", 20020, "protection zone off"),
};
// clang-format on

} // namespace

extern const CodeBook dinplus_m_functions{.language = "dinplus",
                                          .chapter = "M functions",
                                          .source = "SEED-003",
                                          .sections = "MACHINING SUBPROGRAM",
                                          .lines = lines};

} // namespace maclint::code_books
