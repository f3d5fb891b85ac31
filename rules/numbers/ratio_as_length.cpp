//! MAC230: a word of a length gets a ratio.
#include "analyzer/dataflow/facts/point_state.hpp"
#include "analyzer/dataflow/facts/read.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/numbers/mixed_positions.hpp"
#include "rules/numbers/ratio_as_length_finder.hpp"
#include "rules/numbers/ratio_as_length_halves_finder.hpp"
#include "rules/numbers/ratio_as_length_twice_finder.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule ratio_as_length{
    .code = "MAC230",
    .name = "angle-used-as-length",
    .summary =
        "A length is a sine, cosine or tangent, an angle, a place and half of another one, or a position "
        "that counts from another zero",
    .why = "SIN, COS and TAN give how one side compares with another: without the length that they are "
           "multiplied with the axis moves by less than 1.",
    .severity = Severity::note,
    .precision = Precision::high,
    .needs = {Capability::vacancy},
    .facts = dataflow::facts<dataflow::BeforeNode, dataflow::Read>(),
    .messages =
        {{"ratio", "Ratio for a length: '{0}' has no side that it is multiplied with.",
          "Multiply it with the length of the side."},
         {"angle", "Angle for a length: '{0}' holds what ASIN, ACOS or ATAN gives, an angle.",
          "Take the length that was calculated with it."},
         {"half", "Half of a place: '{0}' adds a place and the half of another place of that axis.",
          "Put the sum in brackets where their middle is meant."},
         {"same",
          "One ratio for two axes: '{0}' takes the {1} that '{2}' takes, which no point on a circle has "
          "in both.",
          "Write {3} in one of the two."},
         {"middle", "Middle of one value: '{0}' adds a variable to itself and halves the sum.",
          "Take the second of the two."},
         {"sibling", "Positions of two kinds: '{0}' takes the {1} of its axis, and '{2}' the other kind.",
          "Take the same kind for all axes."},
         {"target",
          "Machine position for a place of the work: '{0}' moves to what '{1}' reads, in the program's "
          "coordinates.",
          "Read the work position, or move by G53."},
         {"machine-move",
          "Work position for a place of the machine: '{0}' takes what '{1}' reads, in a move of machine "
          "coordinates.",
          "Read the machine position."},
         {"difference",
          "Positions of two kinds: '{0}' takes a {1} and one that counts from the other zero from each "
          "other, with a move between.",
          "Read the same kind before and after the move."}},
    .bad = {{"fanuc", R"nc(
O9230(SET G54 WHERE THE TOOL STANDS)
#5221=#5021-10.
#5222=#5042-10.
M99
)nc"},
            {"fanuc", R"nc(
O9230(AWAY AND BACK)
#1=#5021
G91 G28 X0
G90 G0 X#1
M99
)nc"},
            {"fanuc", R"nc(
O9230(CIRCLE, A ANGLE R RADIUS)
G91 G17 G2 X[#18*SIN[#1]] Y-[#18*[1-COS[#1]]] I-SIN[#1] J-[#18*COS[#1]] F200.
G90
M99
)nc"}},
    .good = {{"fanuc", R"nc(
O9230(AWAY AND BACK)
#1=#5021
#2=#5042
G91 G28 Z0
G90 G53 G0 X#1
G0 Y#2
M99
)nc"},
             {"fanuc", R"nc(
O9230(CIRCLE, A ANGLE R RADIUS)
G91 G1 X[#18*SIN[#1]] Y[#18*COS[#1]] F200.
G90
M99
)nc"}},
    .sources = {"T"},
    .check = &check,
};

namespace {

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    report_mixed_positions(analysis, reporter);
    const Program& program = analysis.program();
    for (const AngleAsLength& found : find_angles_as_lengths(program))
        reporter
            .report({analysis, found.word}, found.word, found.is_angle ? "angle" : "ratio",
                    {quoted(program, found.word)})
            .same_cause = program.name; // a habit
    for (const SameRatioTwice& same : find_same_ratios(program))
        reporter.report({analysis, same.second}, same.second, "same",
                        {quoted(program, same.second), same.is_cosine ? "cosine" : "sine",
                         quoted(program, same.first), same.is_cosine ? "SIN" : "COS"});
    for (const HalfOfAPlace& half : find_halves_of_places(analysis)) {
        const Span span = program.expressions[half.sum].span;
        reporter.report({analysis, half.effect, half.sum}, span, half.is_one_place ? "middle" : "half",
                        {quoted(program, span)});
    }
}

} // namespace
} // namespace maclint::rules
