//! DIN PLUS: functions of older controls. Numbers are lines of the manual.
#include "rules/words/code_book.hpp"

namespace maclint::code_books {
namespace {

using namespace book;
using enum Severity;

// clang-format off
constexpr BookLine lines[] = {
    code("G879", 12972, "recess-turning finishing, mentioned only in a list"),
    code("G89", 13027, "used like a cycle closed by G80"),
    code("G119", 19258, "C-axis selection"),
        word("Q", 19258, "number of the selected C axis"),
    code("G25", 20357, "undercut"),
        word("H", 20363, "type", "0 5 6 7").without("0"),
        word("I", 20367, "undercut depth").without("standard table"),
        word("K", 20368, "undercut width").without("standard table"),
        word("R", 20369, "undercut radius").without("standard table"),
        word("P", 20370, "transverse depth").without("standard table"),
        word("W", 20371, "undercut angle").without("standard table"),
        word("A", 20372, "plane angle").without("standard table"),
        word("FP", 20373, "thread pitch").without("from the thread diameter"),
        word("U", 20374, "grinding oversize").without("0"),
        word("E", 20375, "reduced feed").without("active feed"),
    code("G819", 20393, "roughing cycle closed by G80"),
        word("P", 20393, "not described"),
        word("H", 20393, "not described"),
        word("I", 20393, "not described"),
        word("K", 20393, "not described"),
    code("G81", 20407, "simple longitudinal turning"),
        word("X", 20413, "contour start").without("modal"),
        word("Z", 20414, "end point").without("modal"),
        word("I", 20415, "maximum infeed").in_examples(),
        word("K", 20416, "offset in Z").without("0"),
        word("Q", 20417, "infeed with 0 G0, 1 G1", "0 1").without("0"),
        word("V", 20420, "retraction 0,1", "0 1").without("0"),
        word("H", 20423, "smoothing 0,2", "0 2"),
    code("G82", 20451, "simple face turning"),
        word("X", 20457, "end point").without("modal"),
        word("Z", 20458, "start point Z").without("modal"),
        word("I", 20459, "offset in X").without("0"),
        word("K", 20460, "maximum infeed").in_examples(),
        word("Q", 20461, "infeed with 0 G0, 1 G1", "0 1").without("0"),
        word("V", 20464, "retraction 0,1", "0 1").without("0"),
        word("H", 20467, "smoothing 0,2", "0 2"),
    code("G83", 20495, "contour repeat cycle"),
        word("X", 20501, "contour target").without("last X"),
        word("Z", 20502, "contour target").without("last Z"),
        word("I", 20503, "maximum infeed X").in_examples(),
        word("K", 20504, "maximum infeed Z").in_examples(),
        needs("I K", 20506, "", ""),
        alone("X Z I K", 20508, "").as(error).also("DIN009"),
    code("G86", 20551, "recess"),
        word("X", 20557, "base corner X").without("modal"),
        word("Z", 20558, "base corner Z").without("modal"),
        word("I", 20559, "radial").without("axial recess"),
        word("K", 20566, "radial").without("radial recess"),
        word("E", 20573, "dwell").without("time of one spindle revolution"),
    code("G87", 20604, "line with radius"),
        word("X", 20610, "corner").without("modal"),
        word("Z", 20611, "corner").without("modal"),
        word("B", 20612, "radius").needed(),
        word("E", 20613, "reduced feed"),
    code("G88", 20630, "line with chamfer"),
        word("X", 20636, "corner").without("modal"),
        word("Z", 20637, "corner").without("modal"),
        word("B", 20638, "chamfer width").needed(),
        word("E", 20639, "reduced feed"),
    code("G350", 20656, "simple single-start longitudinal thread"),
        word("Z", 20662, "thread end").in_examples(),
        word("F", 20663, "pitch").needed(),
        word("U", 20664, "thread depth").needed(),
        word("I", 20668, "maximum infeed").without("computed from pitch and depth"),
    code("G351", 20684, "multi-start longitudinal thread"),
        word("Z", 20690, "thread end").in_examples(),
        word("F", 20691, "pitch").needed(),
        word("U", 20692, "thread depth").needed(),
        word("I", 20696, "maximum infeed").without("computed from pitch and depth"),
        word("A", 20697, "infeed angle", ">-60 <60").without("30"),
        word("D", 20700, "number of starts").without("1"),
        word("J", 20701, "remaining cutting depth").without("0.01"),
        word("E", 20702, "variable pitch").without("0"),
    code("G15", 23226, "rotary-axis positioning, used with B angle before G16"),
        word("B", 23226, "position of the B axis"),
};
// clang-format on

} // namespace

extern const CodeBook dinplus_older_functions{.language = "dinplus",
                                              .chapter = "functions of older controls",
                                              .source = "SEED-003",
                                              .sections = "MACHINING SUBPROGRAM",
                                              .lines = lines};

} // namespace maclint::code_books
