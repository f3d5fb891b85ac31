//! DIN PLUS: C axis. Numbers are lines of the manual.
#include "rules/words/book_lines.hpp"
#include "rules/words/dinplus/common_lines.hpp"

namespace maclint::code_books {
namespace {

using namespace book;
using enum Severity;

constexpr TableText two_points = "the point is told by X and C or by XK and YK";
constexpr TableText two_angles = "the angle is told by C or as a length by CY";
constexpr TableText two_arcs = "the arc is told by its centre or by its radius";
constexpr TableText in_contours = "it counts in a contour that G80 closes";

// clang-format off
constexpr BookLine lines[] = {
    code("G120", 16286, "reference diameter of the lateral surface"),
        word("X", 16292, "reference diameter").needed("no reference diameter is set"),
    code("G152", 16313, "zero point shift of the C axis"),
        word("C", 16319, "position of the spindle at the new zero point").needed("the zero point stays where it is"),
    code("G153", 16334, "C axis back to 0 to 360 degrees"),
    code("G154", 16342, "shortest way of the C axis"),
        word("H", 16348, "shortest way: 0 off, 1 on", "0 1").needed("nothing is switched"),
    code("G100", 16365, "rapid traverse on the face"),
        word("X", 16373, "end diameter").without("modal"),
        word("C", 16374, "end angle").without("modal"),
        word("XK", 16375, "end point in XK").without("modal"),
        word("YK", 16376, "end point in YK").without("modal"),
        word("Z", 16377, "end point in Z").without("modal"),
        excludes("X C", "XK YK", 16382, two_points).as(error).also("DIN233"),
        wants_c_axis,
    code("G101", 16402, "straight move on the face"),
        word("X", 16408, "end diameter").without("modal"),
        word("C", 16409, "end angle").without("modal"),
        word("XK", 16410, "end point in XK").without("modal"),
        word("YK", 16411, "end point in YK").without("modal"),
        word("Z", 16412, "end point in Z").without("modal"),
        word("AN", 16416, "angle to the positive XK axis"),
        word("BR", 16417, "chamfer or rounding to the next element").without("tangential transition"),
        word("Q", 16423, "choice of the intersection: 0 nearer, 1 farther", "0 1").without("0"),
        excludes("X C", "XK YK", 16432, two_points).as(error).also("DIN233"),
        takes_not("AN BR", 16436, in_contours).also_before("G80").also("DIN663"),
        wants_c_axis,
        refused(12701, "without Q1 the radius is compensated in the XZ plane").while_on("radius compensation in the turning plane"),
    code("G102 G103", 16463, "arc on the face"),
        word("X", 16469, "end diameter").without("modal"),
        word("C", 16470, "end angle").without("modal"),
        word("XK", 16471, "end point in XK").without("modal"),
        word("YK", 16472, "end point in YK").without("modal"),
        word("R", 16473, "radius"),
        word("I", 16474, "centre in XK"),
        word("J", 16475, "centre in YK"),
        word("K", 16476, "centre in Z of H2 and H3"),
        word("Z", 16477, "end point in Z").without("modal"),
        word("H", 16478, "plane of the arc: 0 and 1 XY, 2 YZ, 3 XZ", "0 1 2 3").without("0"),
        word("AN", 16485, "angle to the positive XK axis"),
        word("BR", 16486, "chamfer or rounding to the next element").without("tangential transition"),
        word("Q", 16492, "choice of the intersection: 0 nearer, 1 farther", "0 1").without("0"),
        needs("R I J K", 16529, "radius or centre of the arc", "nobody knows how the arc runs"),
        excludes("X C", "XK YK", 16528, two_points).as(error).also("DIN233"),
        excludes("R", "I J K", 16529, two_arcs).as(error),
        takes_not("K", 16476, "it is a centre of H2 and H3").when("H?0|1 -R"),
        takes_not("J", 16519, "with H2 the centre is told by I and K").when("H=2 -R"),
        takes_not("I", 16520, "with H3 the centre is told by J and K").when("H=3 -R"),
        takes_not("AN BR", 16498, in_contours).also_before("G80").also("DIN663"),
        wants_c_axis,
    code("G110", 16535, "rapid traverse on the lateral surface"),
        word("Z", 16543, "end point in Z").without("modal"),
        word("C", 16544, "end angle").without("modal"),
        word("CY", 16545, "end angle as a length on the reference diameter").without("modal"),
        word("X", 16546, "end diameter"),
        excludes("C", "CY", 16553, two_angles).as(error).also("DIN232"),
        wants_c_axis, wants_reference_diameter,
    code("G111", 16571, "straight move on the lateral surface"),
        word("Z", 16577, "end point in Z").without("modal"),
        word("C", 16578, "end angle").without("modal"),
        word("CY", 16579, "end angle as a length on the reference diameter").without("modal"),
        word("X", 16580, "end diameter"),
        word("AN", 16584, "angle to the positive Z axis"),
        word("BR", 16588, "chamfer or rounding to the next element").without("tangential transition"),
        word("Q", 16594, "choice of the intersection: 0 nearer, 1 farther", "0 1").without("0"),
        excludes("C", "CY", 16603, two_angles).as(error).also("DIN232"),
        takes_not("AN BR", 16607, in_contours).also_before("G80").also("DIN663"),
        wants_c_axis, wants_reference_diameter,
        refused(12702, "without Q2 the radius is compensated in the XZ plane").while_on("radius compensation in the turning plane"),
    code("G112 G113", 16628, "arc on the lateral surface"),
        word("Z", 16634, "end point in Z").without("modal"),
        word("C", 16635, "end angle").without("modal"),
        word("CY", 16636, "end angle as a length on the reference diameter").without("modal"),
        word("R", 16637, "radius"),
        word("K", 16638, "centre in Z"),
        word("J", 16639, "centre as a length on the reference diameter"),
        word("W", 16640, "angle of the centre"),
        word("X", 16641, "end diameter"),
        word("AN", 16645, "angle to the positive Z axis"),
        word("BR", 16646, "chamfer or rounding to the next element").without("tangential transition"),
        word("Q", 16652, "choice of the intersection: 0 nearer, 1 farther", "0 1").without("0"),
        needs("R K J W", 16667, "radius or centre of the arc", "nobody knows how the arc runs"),
        excludes("C", "CY", 16666, two_angles).as(error).also("DIN232"),
        excludes("R", "K J W", 16667, two_arcs).as(error),
        takes_not("AN BR", 16658, in_contours).also_before("G80").also("DIN663"),
        wants_c_axis, wants_reference_diameter,
};
// clang-format on

} // namespace

extern const CodeBook dinplus_c_axis{.language = "dinplus",
                                     .chapter = "C axis",
                                     .source = "SEED-003",
                                     .sections = "MACHINING SUBPROGRAM",
                                     .lines = lines};

} // namespace maclint::code_books
