//! DIN662: an arc that cannot be: its radius is too small, or its ends lie on no circle round its centre.
#include "analyzer/queries/contours/surface_contours.hpp"
#include "analyzer/queries/contours/turning_outline.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"

#include <cmath>
#include <string>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule arc_geometry{
    .code = "DIN662",
    .name = "arc-geometry",
    .aliases = "DIN661",
    .summary = "An arc cannot be: its radius is too small, or its ends lie on no circle round its centre",
    .why = "The control refuses the contour, or the tool leaves it where the arc ends.",
    .severity = Severity::error,
    .precision = Precision::high,
    .needs = {Capability::sections},
    .messages = {{"chord", "Radius too small: the ends of '{0}' are {1} apart, and R{2} spans {3} at most.",
                  "Correct the radius or an end."},
                 {"radii", "Ends on no circle: in '{0}' the start lies {1} from the centre, and the end {2}.",
                  "Correct the centre or an end."}},
    .bad = {{"dinplus", R"nc(
FINISHED
N1 G0 X40 Z0
N2 G1 Z-20
N3 G2 X60 Z-50 R10
N4 G1 Z-70
MACHINING
N10 M30
END
)nc"},
            {"dinplus", R"nc(
FINISHED
N1 G0 X40 Z0
N2 G1 Z-20
N3 G3 X60 Z-30 I0 K-12
N4 G1 Z-70
MACHINING
N10 M30
END
)nc"},
            {"dinplus", R"nc(
FINISHED
N1 G0 X80 Z0
N2 G1 Z-40
FACE_C Z0
N3 G100 XK10 YK0
N4 G101 XK26
N5 G103 XK26 YK16 R7
N6 G101 XK10
MACHINING
N10 M30
END
)nc"}},
    .good = {{"dinplus", R"nc(
FINISHED
N1 G0 X40 Z0
N2 G1 Z-20
N3 G2 X60 Z-30 R10
N4 G1 Z-40
N5 G3 X80 Z-50 I0 K-10
N6 G1 Z-70
MACHINING
N10 M30
END
)nc"}},
    .sources = {"SEED-003:10662-10665", "SEED-003:11640-11692", "SEED-003:12370-12456"},
    .check = &check,
};

namespace {

/// Arcs are written with three places, and rounded corners with fewer.
constexpr double tolerance = 0.05; // mm

std::string length(double value) { return number_word(std::round(value * 1000) / 1000); }

void look_at(const ProgramAnalysis& analysis, const queries::OutlineElement& arc, Reporter& reporter) {
    if (!arc.is_arc || !arc.from || !arc.to) return;
    const std::string block = quoted(analysis.program(), arc.block);
    if (arc.radius) {
        const double chord = queries::distance(*arc.from, *arc.to), most = 2 * std::abs(*arc.radius);
        if (chord > most + tolerance)
            reporter.report({analysis, arc.block}, arc.block, "chord",
                            {block, length(chord), length(*arc.radius), length(most)});
    } else if (arc.centre) {
        const double first = queries::distance(*arc.from, *arc.centre);
        const double second = queries::distance(*arc.to, *arc.centre);
        if (std::abs(first - second) > tolerance)
            reporter.report({analysis, arc.block}, arc.block, "radii",
                            {block, length(first), length(second)});
    }
}

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    for (const queries::Outline& outline : queries::turning_contours_and_moves(analysis.program()))
        for (const queries::OutlineElement& element : outline.elements) look_at(analysis, element, reporter);
    for (const queries::SurfaceContour& contour : queries::surface_contours(analysis.program()))
        for (const queries::OutlineElement& element : contour.elements) look_at(analysis, element, reporter);
}

} // namespace
} // namespace maclint::rules
