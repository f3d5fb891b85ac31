//! DIN PLUS: compensation, zero shifts and oversizes. Numbers are lines of the manual.
#include "rules/words/book_lines.hpp"
#include "rules/words/dinplus/codes.hpp"
#include "rules/words/dinplus/common_lines.hpp"

namespace maclint::code_books {
namespace {

using namespace book;
using enum Severity;

/// Cycles that take the oversizes set before them [l.12867, l.12893, l.14329].
constexpr TableText turning_cycles = "G81 G82 G83 G810 G820 G830 G835 G860 G869 G870 G890 G891 G895";

/// What may stand between G41 and the straight move: it moves nothing [l.12718].
constexpr TableText no_moves =
    "G4 G7 G8 G9 G26 G126 G226 G326 G47 G147 G48 G64 G93 G193 G293 G393 G94 G95 G195 G295 G395 G96 G196 G296 "
    "G396 G97 G197 G297 G397 G148 G149 G150 G151 G908 G909 G919";

// clang-format off
constexpr BookLine lines[] = {
    code("G40", 12673, "end of radius compensation"),
        apart("G2 G3 G12 G13 G102 G103 G112 G113", 12680, "compensation ends on a straight move").as(error).also("DIN620"),
        // G14 is not allowed there either, but programs that are right otherwise have it.
        not_before("G2 G3 G12 G13 G102 G103 G112 G113", 12680, "compensation ends on a straight move").when("-G -X -Z").as(error).also("DIN620"),
    code("G41 G42", 12692, "radius compensation left or right of the contour"),
        word("Q", 12701, "plane: 0 XZ, 1 XC, 2 ZC, 3 XY, 4 YZ", "0 1 2 3 4").without("0"),
        word("H", 12707, "areas that overlap: 0 left out, 1 machined", "0 1").without("0"),
        word("O", 12710, "feed reduction: 0 on, 1 off", "0 1").without("0"),
        only_with("H", "Q=1|2|3|4", 12707, "it counts for milling cutters").when("H=1"),
        alone("Q H O", 12716, "compensation begins with the move of the next block").also("DIN010"),
        precedes("G0 G1 G40 G100 G101 G110 G111", 12717, "compensation begins on a straight move").unless_next(no_moves).as(error).also("DIN617"),
    code("G51", 12750, "zero point shift"),
        word("X", 12756, "shift in X, a radius").without("axis not shifted"),
        word("Y", 12757, "shift in Y").without("axis not shifted"),
        word("Z", 12758, "shift in Z").without("axis not shifted"),
        word("U", 12759, "shift in U").without("axis not shifted"),
        word("V", 12760, "shift in V").without("axis not shifted"),
        word("W", 12761, "shift in W").without("axis not shifted"),
        no_shift_in_tilted_plane,
    code("G53 G54 G55", 12777, "zero point shift by a stored offset"),
        no_shift_in_tilted_plane,
    code("G56", 12793, "additive zero point shift"),
        word("X", 12799, "shift in X, a radius").without("axis not shifted"),
        word("Y", 12800, "shift in Y").without("axis not shifted"),
        word("Z", 12801, "shift in Z").without("axis not shifted"),
        word("U", 12802, "shift in U").without("axis not shifted"),
        word("V", 12803, "shift in V").without("axis not shifted"),
        word("W", 12804, "shift in W").without("axis not shifted"),
        no_shift_in_tilted_plane,
    code("G59", 12822, "absolute zero point shift"),
        word("X", 12828, "shift in X, a radius").without("axis not shifted"),
        word("Y", 12829, "shift in Y").without("axis not shifted"),
        word("Z", 12830, "shift in Z").without("axis not shifted"),
        word("U", 12831, "shift in U").without("axis not shifted"),
        word("V", 12832, "shift in V").without("axis not shifted"),
        word("W", 12833, "shift in W").without("axis not shifted"),
        no_shift_in_tilted_plane,
    code("G50", 12850, "oversize of the contour off"),
        apart(turning_cycles, 12852, "it stands before the cycle"),
    code("G52", 12850, "oversize of the contour off, written G50 today"),
        apart(turning_cycles, 12852, "it stands before the cycle"),
    code("G57", 12856, "oversize in X and Z"),
        word("X", 12862, "oversize in X", ">=0").or_else("only positive oversizes are taken").as(error).also("DIN636"),
        word("Z", 12863, "oversize in Z", ">=0").or_else("only positive oversizes are taken").as(error).also("DIN636"),
        apart(turning_cycles, 12858, "it stands before the cycle"),
    code("G58", 12883, "equidistant oversize"),
        word("P", 12889, "equidistant oversize").needed("no oversize is set"),
        // G891 uses it, too [14328].
        value("P", ">=0", 12885, "only G890 and G891 take a negative oversize").also_before("G890 G891").also("DIN637"),
        apart(turning_cycles, 12885, "it stands before the cycle"),
    code("G47", 12911, "safety distance"),
        word("P", 12921, "safety distance").without("machine parameter DefGlobG47P"),
    code("G147", 12929, "safety distance of drilling and milling"),
        word("I", 12938, "safety distance in the milling plane").without("machine parameter DefGlobG147SCI"),
        word("K", 12939, "safety distance in the infeed direction").without("machine parameter DefGlobG147SCK"),
    code("G148", 12959, "choice of the wear corrections"),
        word("O", 12965, "corrections: 0 DX and DZ, 1 DS and DZ, 2 DX and DS", "0 1 2").without("0"),
    code("G149", 12998, "additive correction"),
        word("D", 13006, "number of the correction, 900 is none", "900..916").without("900").or_else("there is no such correction").as(error).also("DIN624"),
        apart(motions, 13012, "the correction counts from the block after").also("DIN625"),
    code("G150", 13045, "right tool tip is the reference"),
        apart("G151", 10226, "one tip is the reference"),
        side_changes_with_tip,
    code("G151", 13045, "left tool tip is the reference"),
        side_changes_with_tip,
    code("G920", 18155, "zero point shifts off"),
        kept_in_hdt_mode,
    code("G921", 18161, "zero point shifts and tool dimensions off"),
        kept_in_hdt_mode,
    code("G980", 18391, "zero point shifts on"),
        kept_in_hdt_mode,
        refused(18397, "tool lengths come back with G981").while_on("suspension of zero points and tool lengths").also("DIN635"),
    code("G981", 18395, "zero point shifts and tool dimensions on"),
        kept_in_hdt_mode,
        refused(18393, "what G920 has switched off comes back with G980").while_on("suspension of zero points").also("DIN635"),
};
// clang-format on

} // namespace

extern const CodeBook dinplus_compensation{.language = "dinplus",
                                           .chapter = "compensation, zero shifts and oversizes",
                                           .source = "SEED-003",
                                           .sections = "MACHINING SUBPROGRAM",
                                           .lines = lines};

} // namespace maclint::code_books
