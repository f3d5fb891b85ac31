//! DIN PLUS: words that stand beside the name of a section or in its blocks. Numbers are lines of the manual.
#include "rules/words/book_lines.hpp"

namespace maclint::code_books {
namespace {

using namespace book;

// clang-format off
constexpr BookLine lines[] = {
    code("CHUCKING_EQUIPMENT", 2756, "chucking equipment of a spindle"),
        word("H", 2762, "number of the chucking equipment"),
        word("D", 2763, "number of the spindle for the automatic working plan"),
        word("R", 2764, "kind of length that J tells", "0 1"),
        word("Z", 2767, "position of the chuck's edge"),
        word("B", 2768, "reference of the jaws"),
        word("J", 2769, "clamping or free length"),
        word("O", 2770, "cutting limit outside"),
        word("I", 2771, "cutting limit inside"),
        word("K", 2772, "overlap of jaw and workpiece"),
        word("X", 2773, "clamping diameter of the blank"),
        word("Q", 2774, "form of clamping", "4 5"),
        word("V", 2777, "shaft machining of the automatic working plan", "0 1 2"),
    code("TURRET", 2791, "tools of a turret"),
        word("T", 3101, "number of the place"),
        word("ID", 3102, "identification of the tool").needed("the place holds no tool"),
        word("AT", 3103, "tool that replaces it"),
        word("AS", 3104, "kind of replacement", "0 1"),
        word("BW", 25596, "angle of the B axis"),
        word("CW", 25597, "position of the tool"),
    code("CONTOUR", 2823, "position of a contour group"),
        word("Q", 2831, "number of the contour group", "1..4"),
        word("X", 2832, "position in the graphics"),
        word("Z", 2833, "position in the graphics"),
        word("V", 2834, "coordinate system", "0 2").or_else("it is the machine's or the mirrored one"),
    code("FACE_C REAR_C", 2854, "contours on a face for the C axis"),
        word("Z", 2860, "position of the contours"),
    code("LATERAL_C", 2862, "contours on the lateral surface for the C axis"),
        word("X", 2868, "reference diameter"),
    code("FACE_Y REAR_Y", 2870, "contours on a face for the Y axis"),
        word("X", 2876, "diameter of the cutting limit"),
        word("Z", 2877, "position of the reference plane").without("0"),
        word("C", 2878, "angle of the spindle").without("0"),
    code("LATERAL_Y", 2880, "contours in a plane beside the axis, for the Y axis"),
        word("X", 2888, "reference diameter"),
        word("C", 2889, "angle of the spindle"),
        word("B", 2903, "angle of the plane to the Z axis"),
        word("I", 2904, "reference of the plane in X, as a radius"),
        word("K", 2905, "reference of the plane in Z"),
        word("H", 2906, "shift of the turned coordinate system", "0 1").without("0"),
};
// clang-format on

} // namespace

extern const CodeBook dinplus_sections{
    .language = "dinplus", .chapter = "sections", .source = "SEED-003", .sections = {}, .lines = lines};

} // namespace maclint::code_books
