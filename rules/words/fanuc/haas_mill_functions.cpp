//! Machine functions of Haas mills alone.
#include "rules/words/cited_lines.hpp"

namespace maclint::code_books {
namespace {

using namespace book;

// clang-format off
constexpr BookLine lines[] = {
    code("M6", "H10:217", "tool change"),
        word("T", "H10:217", "tool").without("tool selected before"),
    code("M7", "T", "shower coolant on"),
    code("M10 M11", "T", "brake of the fourth axis on (M10), off (M11)"),
    code("M12 M13", "T", "brake of the fifth axis on (M12), off (M13)"),
    code("M16", "T", "tool change, as M6"),
        word("T", "T", "tool"),
    code("M17 M18", "T", "pallet released (M17), clamped (M18), with the door"),
    code("M21 M22 M23 M24 M25 M26 M27 M28", "H10:217", "output of the shop, until the machine answers"),
    code("M34 M35", "T", "coolant nozzle one step down (M34), up (M35)"),
    code("M36", "T", "wait for a pallet that is ready"),
        word("P", "T", "number of the pallet"),
    code("M39", "T", "turning of the tool carousel"),
        word("T", "T", "pocket"),
    code("M46", "T", "jump where a pallet is loaded"),
        word("P", "T", "number of the block to go on at").needed("nothing says where to go on"),
        word("Q", "T", "number of the pallet"),
    code("M48", "T", "check of the pallet program"),
    code("M49", "T", "state of a pallet"),
        word("P", "T", "number of the pallet"),
        word("Q", "T", "state"),
    code("M50", "T", "pallet change"),
        word("P", "T", "number of the pallet"),
    code("M73 M74", "T", "tool air blast on (M73), off (M74)"),
        word("P", "T", "time"),
    code("M75", "H99:170", "reference point for G35 or G136"),
    code("M80 M81", "T", "automatic door open (M80), closed (M81)"),
    code("M82 M86", "T", "tool released (M82), clamped (M86)"),
    code("M83 M84", "T", "air gun on (M83), off (M84)"),
    code("M90 M91", "T", "fixture clamp watched on (M90), off (M91)"),
    code("M104 M105", "T", "probe arm out (M104), in (M105)"),
    code("M160", "T", "end of the minimal lubrication in force"),
    code("M161", "T", "minimal lubrication, continuous"),
        word("P", "T", "seconds between squirts"),
        word("Q R", "T", "number of squirts"),
    code("M162", "T", "minimal lubrication, once"),
        word("P", "T", "number of squirts"),
        word("Q R", "T", "values that nobody has described"),
    code("M163", "T", "minimal lubrication at each hole"),
        word("P", "T", "number of squirts"),
        word("Q R", "T", "values that nobody has described"),
    code("M170 M171", "T", "brake of an axis on (M170), off (M171)"),
};
// clang-format on

} // namespace

extern const CodeBook haas_mill_functions{.language = "fanuc",
                                          .chapter = "machine functions of Haas mills",
                                          .source = "T",
                                          .sections = "",
                                          .machine = Machine::mill,
                                          .controls = "haas haas-1999",
                                          .lines = lines};

} // namespace maclint::code_books
