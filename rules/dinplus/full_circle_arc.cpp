//! DIN229: an arc of a contour that ends where it begins.
#include "analyzer/queries/contours/surface_contours.hpp"
#include "analyzer/queries/contours/turning_outline.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule full_circle_arc{
    .code = "DIN229",
    .name = "full-circle-arc",
    .summary = "An arc of a contour ends where it begins",
    .why = "The control takes no full circle in a contour, and stops with an error.",
    .severity = Severity::error,
    .precision = Precision::high,
    .needs = {Capability::sections},
    .messages = {{"plain", "Full circle in a contour: '{0}' ends where it begins.",
                  "Write two arcs, or correct the end."}},
    .bad = {{"dinplus", R"nc(
FINISHED
N1 G0 X40 Z0
N2 G1 Z-20
N3 G2 X40 Z-20 R10
N4 G1 Z-70
MACHINING
N10 M30
END
)nc"}},
    .good = {{"dinplus", R"nc(
FINISHED
N1 G0 X40 Z0
N2 G1 Z-20
N3 G2 X60 Z-30 R10
N4 G1 Z-70
MACHINING
N10 M30
END
)nc"}},
    .sources = {"SEED-003:11692", "SEED-003:22518"},
    .check = &check,
};

namespace {

void look_at(const ProgramAnalysis& analysis, const queries::OutlineElement& arc, Reporter& reporter) {
    constexpr double nothing = 1e-6; // mm
    if (arc.is_arc && arc.from && arc.to && queries::distance(*arc.from, *arc.to) < nothing)
        reporter.report({analysis, arc.block}, arc.block, "plain", {quoted(analysis.program(), arc.block)});
}

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    for (const queries::Outline& outline : queries::turning_contours(analysis.program()))
        for (const queries::OutlineElement& element : outline.elements) look_at(analysis, element, reporter);
    for (const queries::SurfaceContour& contour : queries::surface_contours(analysis.program()))
        for (const queries::OutlineElement& element : contour.elements) look_at(analysis, element, reporter);
}

} // namespace
} // namespace maclint::rules
