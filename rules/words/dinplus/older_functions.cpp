//! DIN PLUS: functions of older controls. Numbers are lines of the manual.
#include "rules/words/book_lines.hpp"
#include "rules/words/dinplus/common_lines.hpp"

namespace maclint::code_books {
namespace {

using namespace book;
using enum Severity;

constexpr TableText not_described = "the manual names it without saying what it takes";

// clang-format off
constexpr BookLine lines[] = {
    code("G879", 12972, "finishing of recesses, named beside G869 alone").off(not_described),
    code("G89", 13027, "cycle of an example, closed by G80").off(not_described),
    code("G119", 19258, "choice of the C axis, named among the variables alone").off(not_described),
        word("Q", 19258, "number of the C axis"),
    code("G25", 20357, "undercut in the contour of a cycle"),
        word("H", 20363, "form: 0 and 5 DIN 509 E, 6 DIN 509 F, 7 DIN 76", "0 5 6 7").without("0"),
        word("I", 20367, "depth of the undercut").without("standard table"),
        word("K", 20368, "width of the undercut").without("standard table"),
        word("R", 20369, "radius of the undercut").without("standard table"),
        word("P", 20370, "depth across").without("standard table"),
        word("W", 20371, "angle of the undercut").without("standard table"),
        word("A", 20372, "angle of the face").without("standard table"),
        word("FP", 20373, "pitch of the thread").without("from the diameter of the thread"),
        word("U", 20374, "oversize for grinding").without("0"),
        word("E", 20375, "reduced feed").without("active feed"),
    code("G819", 20393, "roughing cycle of an example, closed by G80").off(not_described),
        word("P", 20393, "word of an example"),
        word("H", 20393, "word of an example"),
        word("I", 20393, "word of an example"),
        word("K", 20393, "word of an example"),
    // The greatest depth of a cut has either sign in the examples [20446, 20490].
    code("G81", 20407, "simple longitudinal turning"),
        word("X", 20413, "starting diameter of the contour").without("modal"),
        word("Z", 20414, "end point in Z").without("modal"),
        word("I", 20415, "greatest depth of a cut").in_examples(),
        word("K", 20416, "offset in Z").without("0"),
        word("Q", 20417, "infeed: 0 rapid traverse, 1 feed", "0 1").without("0"),
        word("V", 20420, "way back: 0 in Z alone, 1 to the start", "0 1").without("0"),
        word("H", 20423, "smoothing: 0 after each cut, 2 none", "0 2"),
    code("G82", 20451, "simple face turning"),
        word("X", 20457, "end diameter").without("modal"),
        word("Z", 20458, "starting point in Z").without("modal"),
        word("I", 20459, "offset in X").without("0"),
        word("K", 20460, "greatest depth of a cut").in_examples(),
        word("Q", 20461, "infeed: 0 rapid traverse, 1 feed", "0 1").without("0"),
        word("V", 20464, "way back: 0 in X alone, 1 to the start", "0 1").without("0"),
        word("H", 20467, "smoothing: 0 after each cut, 2 none", "0 2"),
        wants_speed_limit,
    code("G83", 20495, "repetition of the blocks up to G80"),
        word("X", 20501, "target diameter").without("last X"),
        word("Z", 20502, "target in Z").without("last Z"),
        word("I", 20503, "greatest depth of a cut in X").in_examples(),
        word("K", 20504, "greatest depth of a cut in Z").in_examples(),
        needs("I K", 20506, "greatest depth of a cut", "nothing is repeated"),
        alone("X Z I K", 20510, "it repeats the blocks after it up to G80").as(error).also("DIN009"),
        refused(20512, "the control does not nest it").while_on("contour of G83").as(error).also("DIN419"),
    code("G86", 20551, "simple recess"),
        word("X", 20557, "diameter of the base corner").without("modal"),
        word("Z", 20558, "base corner in Z").without("modal"),
        word("I", 20559, "oversize of a radial recess, width of an axial one", ">=0").without("width of the tool in an axial recess").or_else("there is no negative oversize or width"),
        word("K", 20566, "width of a radial recess, oversize of an axial one", ">=0").without("width of the tool in a radial recess").or_else("there is no negative oversize or width"),
        word("E", 20573, "dwell").without("time of one revolution"),
    code("G87", 20604, "rounding of a corner"),
        word("X", 20610, "diameter of the corner").without("modal"),
        word("Z", 20611, "corner in Z").without("modal"),
        word("B", 20612, "radius").needed("the corner stays sharp"),
        word("E", 20613, "reduced feed"),
    code("G88", 20630, "chamfer of a corner"),
        word("X", 20636, "diameter of the corner").without("modal"),
        word("Z", 20637, "corner in Z").without("modal"),
        word("B", 20638, "width of the chamfer").needed("the corner stays sharp"),
        word("E", 20639, "reduced feed"),
    // U 999 and -999: the control calculates the depth.
    code("G350", 20656, "simple longitudinal thread"),
        word("Z", 20662, "end of the thread").needed("the thread has no length"),
        word("F", 20663, "pitch of the thread").needed("the thread has no pitch"),
        word("U", 20664, "depth of the thread, above 0 inside").needed("the thread has no depth"),
        word("I", 20668, "greatest depth of a cut").without("calculated from pitch and depth"),
        not_under_constant_cutting_speed, not_while_speed_swings,
    code("G351", 20684, "longitudinal thread of several starts"),
        word("Z", 20690, "end of the thread").needed("the thread has no length"),
        word("F", 20691, "pitch of the thread").needed("the thread has no pitch"),
        word("U", 20692, "depth of the thread, above 0 inside").needed("the thread has no depth"),
        word("I", 20696, "greatest depth of a cut").without("calculated from pitch and depth"),
        word("A", 20697, "infeed angle", ">-60 <60").without("30"),
        word("D", 20700, "number of starts").without("1"),
        word("J", 20701, "depth of the last cut").without("0.01"),
        word("E", 20702, "change of the pitch per revolution").without("0"),
        not_under_constant_cutting_speed, not_while_speed_swings,
    code("G15", 23226, "turning of the B axis, in the example of G16 alone").off(not_described),
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
