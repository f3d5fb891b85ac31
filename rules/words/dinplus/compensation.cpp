//! DIN PLUS: compensation, zero shifts and oversizes. Numbers are lines of the manual.
#include "rules/words/code_book.hpp"
#include "rules/words/dinplus/codes.hpp"

namespace maclint::code_books {
namespace {

using namespace book;
using enum Severity;

// clang-format off
constexpr BookLine lines[] = {
    code("G40", 12673, "switch off tooth/cutter radius compensation"),
        apart("G2 G3 G12 G13 G102 G103 G112 G113", 12680, "compensation ends on a straight move").as(error),
    code("G41", 12692, "switch on radius compensation"),
        word("Q", 12701, "plane", "0 1 2 3 4").without("0"),
        word("H", 12707, "output, FRK only", "0 1").without("0"),
        word("O", 12710, "feed reduction off", "0 1").without("0"),
        only_with("H", "Q=1|2|3|4", 12707, ""),
        alone("Q H O", 12716, "").also("DIN010"),
        precedes("G0 G1 G40 G100 G101 G110 G111", 12717, "compensation begins on a straight move").as(error).also("DIN617"),
    code("G42", 12692, "switch on radius compensation"),
        word("Q", 12701, "plane", "0 1 2 3 4").without("0"),
        word("H", 12707, "output, FRK only", "0 1").without("0"),
        word("O", 12710, "feed reduction off", "0 1").without("0"),
        only_with("H", "Q=1|2|3|4", 12707, ""),
        alone("Q H O", 12716, "").also("DIN010"),
        precedes("G0 G1 G40 G100 G101 G110 G111", 12717, "compensation begins on a straight move").as(error).also("DIN617"),
    code("G51", 12750, "zero point shift"),
        word("X", 12756, "shift").without("axis not selected"),
        word("Y", 12757, "shift").without("axis not selected"),
        word("Z", 12758, "shift").without("axis not selected"),
        word("U", 12759, "shift").without("axis not selected"),
        word("V", 12760, "shift").without("axis not selected"),
        word("W", 12761, "shift").without("axis not selected"),
        apart(motions, 12753, "it stands in the block before"),
    code("G53", 12777, "zero point shift by stored offset"),
    code("G54", 12777, "zero point shift by stored offset"),
    code("G55", 12777, "zero point shift by stored offset"),
    code("G56", 12793, "additive zero point shift"),
        word("X", 12799, "shift").without("axis not selected"),
        word("Y", 12800, "shift").without("axis not selected"),
        word("Z", 12801, "shift").without("axis not selected"),
        word("U", 12802, "shift").without("axis not selected"),
        word("V", 12803, "shift").without("axis not selected"),
        word("W", 12804, "shift").without("axis not selected"),
        apart(motions, 12803, "it stands in the block before"),
    code("G59", 12822, "absolute zero point shift"),
        word("X", 12828, "shift").without("axis not selected"),
        word("Y", 12829, "shift").without("axis not selected"),
        word("Z", 12830, "shift").without("axis not selected"),
        word("U", 12831, "shift").without("axis not selected"),
        word("V", 12832, "shift").without("axis not selected"),
        word("W", 12833, "shift").without("axis not selected"),
        apart(motions, 12824, "it stands in the block before"),
    code("G50", 12850, "switch off oversize"),
    code("G52", 12850, "switch off oversize"),
    code("G57", 12856, "axis-parallel oversize"),
        word("X", 12862, "oversize X", ">=0").without("one example, it has both words").or_else("only positive oversizes are taken").as(error).also("DIN636"),
        word("Z", 12863, "oversize Z", ">=0").without("one example, it has both words").or_else("only positive oversizes are taken").as(error).also("DIN636"),
        apart(motions, 12858, "it stands in the block before"),
    code("G58", 12883, "contour-parallel oversize"),
        word("P", 12889, "oversize").needed("no oversize is set"),
    code("G47", 12911, "safety clearance"),
        word("P", 12921, "clearance").without("value of machine parameter DefGlobG47P"),
    code("G147", 12929, "safety clearance"),
        word("I", 12938, "clearance in milling plane").without("machine parameter DefGlobG147SCI"),
        word("K", 12939, "clearance in infeed direction").without("machine parameter DefGlobG147SCK"),
    code("G148", 12959, "cutter compensation"),
        word("O", 12965, "selection", "0 1 2").without("0"),
    code("G149", 12998, "additive compensation"),
        word("D", 13006, "900 off, 901..916 on", "900 901 902 903 904 905 906 907 908 909 910 911 912 913 914 915 916").without("900").or_else("there is no such correction").as(error).also("DIN624"),
        apart(motions, 13012, "it stands in the block before"),
    code("G150", 13045, "compensation of right / left tool tip"),
    code("G151", 13045, "compensation of right / left tool tip"),
    code("G920", 18155, "deactivate zero point shifts"),
    code("G921", 18161, "deactivate zero point shifts and tool dimensions"),
    code("G980", 18391, "activate zero point shifts"),
    code("G981", 18395, "activate zero point shifts and tool dimensions"),
};
// clang-format on

} // namespace

extern const CodeBook dinplus_compensation{.language = "dinplus",
                                           .chapter = "compensation, zero shifts and oversizes",
                                           .source = "SEED-003",
                                           .sections = "MACHINING SUBPROGRAM",
                                           .lines = lines};

} // namespace maclint::code_books
