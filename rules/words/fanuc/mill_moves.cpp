//! Moves, arcs, threads and dwell of Fanuc mills.
#include "rules/words/cited_lines.hpp"

namespace maclint::code_books {
namespace {

using namespace book;
using enum Severity;
constexpr TableText no_centre = "the control stops, or moves straight";
constexpr TableText of_16i = "FANUC 16i/18i/21i", of_30i = "FANUC 30i/0i-D";
/// Where others that nobody has named write otherwise.
constexpr TableText named = "fanuc-16i fanuc-0i-c fanuc-0i-d fanuc-30i";
constexpr TableText newer = "fanuc-0i-d fanuc-30i";
constexpr TableText axes = "X Y Z A B C U V W";

// Words that any block may hold (F, S, T, M, H, D) are listed only where the move itself takes them: a block
// that goes on with a move takes all words of its code.
// clang-format off
constexpr BookLine lines[] = {
    code("G0", "SEED-001:1340", "rapid positioning"),
        word(axes, "T", "end point").without("present position"),
    code("G1", "SEED-001:1340", "straight cut"),
        word(axes, "T", "end point").without("present position"),
        word("F", "CSDN-PS", "feed").without("feed in force"),
        word(",C ,R", "T", "chamfer or radius before the next move (option)"),
        word(",A", "T", "angle of the straight line (option)"),
        needs("F", "GH-ALM", "feed", "the control stops: it is asked for in each block").under("G93").on(newer).as(error).alarm(of_30i, "1202"),
    code("G2 G3", "F15-71", "arc, helix: clockwise, counter-clockwise"),
        word("X Y Z", "F15-71", "end point; the third axis makes a helix").without("start point"),
        word("A B C U V W", "T", "end point of an axis that goes along").without("present position"),
        word("I J K", "F15-71", "centre, from the start point").without("0"),
        word("R", "F15-71", "radius; negative: an arc of more than 180 degrees"),
        word("F", "CSDN-PS", "feed along the arc").without("feed in force"),
        word("L", "F30C-99", "number of turns of a spiral (option)"),
        word("Q", "F30C-99", "change of radius in each turn of a spiral (option)"),
        word(",C ,R", "T", "chamfer or radius before the next move (option)"),
        needs("R I J K", "CSDN-PS", "radius or centre", no_centre).when("X").alarm(of_16i, "022").alarm(of_30i, "022").also("MAC557"),
        needs("R I J K", "CSDN-PS", "radius or centre", no_centre).when("Y -X").alarm(of_16i, "022").alarm(of_30i, "022").also("MAC557"),
        needs("R I J K", "CSDN-PS", "radius or centre", no_centre).when("Z -X -Y").alarm(of_16i, "022").alarm(of_30i, "022").also("MAC557"),
        at_most(4, "X Y Z U V W A B C", "GH-ALM", "an arc takes two axes along, beside those of its plane").alarm(of_30i, "232"),
        excludes("R", "I J K", "F15-71", "only the radius counts").also("MAC571"),
        excludes("R", "L Q", "F30C-99", "a spiral has a centre, not a radius").on(named),
        value("L", ">0", "F30C-99", "the spiral has no turns").on(named),
        needs("F", "GH-ALM", "feed", "the control stops: it is asked for in each block").under("G93").on(newer).as(error).alarm(of_30i, "1202"),
    code("G2.2 G3.2", "GH-ALM", "involute: clockwise, counter-clockwise (option)"),
        word("X Y Z", "GH-ALM", "end point"),
        word("I J K", "GH-ALM", "centre of the base circle, from the start point"),
        word("R", "GH-ALM", "radius of the base circle"),
        word("F", "T", "feed along the curve").without("feed in force"),
        needs("I J K", "GH-ALM", "centre of the base circle", "the curve has no base circle").alarm(of_30i, "241"),
        needs("R", "GH-ALM", "radius of the base circle", "the curve has no base circle").alarm(of_30i, "241"),
    code("G2.3 G3.3", "F15-104", "exponential curve, by direction of turn (option)"),
        word("X Y Z", "F15-104", "end point"),
        word("I J", "F15-104", "angles of the curve"),
        word("K", "F15-104", "length of the pieces of the curve", ">0").without("that of a parameter"),
        word("R", "F15-104", "constant of the curve"),
        word("F", "F15-104", "feed at the start").without("feed in force"),
        word("Q", "F15-104", "feed at the end"),
    code("G2.4 G3.4", "F15-779", "arc through three points in space (option)"),
        word(axes, "F15-779", "point on the way, in the next block end point"),
        word("F", "T", "feed along the arc").without("feed in force"),
        needs(axes, "F15-779", "point on the way or end point", "the arc has no point there"),
    code("G4", "T", "dwell; alone it is an exact stop"),
        word("X U", "T", "time in seconds"),
        word("P", "T", "time in ms"),
        word("Q", "GH-ALM", "skip signal that ends the dwell (option)"),
        word("F", "T", "feed that is set beside the time"),
        excludes("X", "P", "T", "only one of the two times counts"),
        only_with("F", "X P", "T", "the control does not wait"),
        whole("P", "T", "the control stops").on(named),
        value("Q", "1 2 3 4", "GH-ALM", "there is no such signal").on(named),
        takes_not("T", "GH-ALM", "the control takes no tool in this block").alarm(of_30i, "245"),
    code("G6.2", "T", "NURBS curve (option)"),
        word("P", "T", "order of the curve"),
        word("K", "T", "knot"),
        word(axes, "T", "control point"),
        word("R", "T", "weight of the point").without("1"),
        word("I J", "T", "direction of the tool"),
        word("F", "T", "feed along the curve").without("feed in force"),
    code("G9", "T", "exact stop at the end of this block"),
        word(axes, "T", "end point of a move that the code in force makes"),
        word("F", "T", "feed").without("feed in force"),
    code("G33", "T", "thread with a constant lead (option)"),
        word("X Y Z", "T", "end point"),
        word("F", "T", "lead in the direction of the longest way"),
        word("E", "T", "lead as threads an inch"),
        word("Q", "T", "start angle in 0.001 degrees").without("0"),
        needs("X Y Z U V W", "T", "end point", "no thread is cut"),
        value("Q", "0..360000", "T", "there is no such angle"),
    code("G34", "T", "thread with a variable lead (option)"),
        word("X Y Z", "T", "end point"),
        word("F", "T", "lead at the start"),
        word("K", "T", "change of the lead in each turn"),
        word("Q", "T", "start angle in 0.001 degrees").without("0"),
    code("G35", "F30D-155", "circular thread, clockwise (option)"),
        word("X Y Z", "F30D-155", "end point"),
        word("I J K", "F30D-155", "centre, from the start point"),
        word("R", "F30D-155", "radius"),
        word("F", "F30D-155", "lead in the direction of the longest way"),
        word("Q", "F30D-155", "start angle in 0.001 degrees", "0..360000").without("0"),
        whole("Q", "F30D-155", "the control stops").on(named),
    code("G36", "F30D-155", "circular thread, counter-clockwise, or measuring"),
        word(axes, "F30D-155", "end point, or measuring position"),
        word("I J K", "F30D-155", "centre, from the start point"),
        word("R", "F30D-155", "radius"),
        word("F", "F30D-155", "lead in the direction of the longest way"),
        word("Q", "F30D-155", "start angle in 0.001 degrees", "0..360000").without("0"),
    code("G60", "T", "positioning from one side"),
        word(axes, "T", "end point, reached from one side in each axis"),
};
// clang-format on

} // namespace

extern const CodeBook fanuc_mill_moves{.language = "fanuc",
                                       .chapter = "moves and dwell of mills",
                                       .source = "T",
                                       .sections = "",
                                       .machine = Machine::mill,
                                       .controls = "fanuc fanuc-16i fanuc-0i-c fanuc-0i-d fanuc-30i",
                                       .lines = lines};

} // namespace maclint::code_books
