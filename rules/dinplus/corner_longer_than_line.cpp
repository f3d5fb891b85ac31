//! DIN239: a chamfer or rounding that is longer than the line which it stands on.
#include "analyzer/queries/contours/turning_outline.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"

#include <cmath>
#include <numbers>
#include <optional>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule corner_longer_than_line{
    .code = "DIN239",
    .name = "corner-longer-than-line",
    .summary = "A chamfer or rounding is longer than a line that it stands on",
    .why = "The corner does not fit: the control refuses the contour.",
    .severity = Severity::error,
    .precision = Precision::high,
    .needs = {Capability::sections},
    .messages = {{"plain", "Chamfer longer than its line: '{0}' cuts {1} off, and the line is {2} long.",
                  "Correct the chamfer, or the length of the line."},
                 {"rounding",
                  "Rounding longer than its line: '{0}' takes {1} of it, and the line is {2} long.",
                  "Correct the radius, or the length of the line."}},
    .bad = {{"dinplus", R"nc(
FINISHED
N1 G0 X0 Z0
N2 G1 X40 BR-5
N3 G1 Z-3
N4 G1 X60
N5 G1 Z-40
MACHINING
N10 M30
END
)nc"},
            {"dinplus", R"nc(
FINISHED
N1 G0 X0 Z0
N2 G1 X40
N3 G1 Z-20
N4 G1 X46 BR5
N5 G1 Z-40
MACHINING
N10 M30
END
)nc"}},
    .good = {{"dinplus", R"nc(
FINISHED
N1 G0 X0 Z0
N2 G1 X40 BR-2
N3 G1 Z-3
N4 G1 X60
N5 G1 Z-40
MACHINING
N10 M30
END
)nc"}},
    .sources = {"SEED-003:10606-10611"},
    .check = &check,
};

namespace {

constexpr double rounding = 0.001; // mm

/// How long a straight element is; nothing where nobody can say.
std::optional<double> length_of(const queries::OutlineElement& element) {
    if (element.is_arc || !element.from || !element.to) return std::nullopt;
    return queries::distance(*element.from, *element.to);
}

/// What the corner takes of both its lines: a chamfer its width, a rounding the way to where it touches
/// them. Nothing where nobody can say.
std::optional<double> taken_by(const queries::OutlineElement& before, const queries::OutlineElement& behind) {
    if (*before.corner < 0) return -*before.corner;
    if (!length_of(before) || !length_of(behind)) return std::nullopt;
    const double turn = std::atan2(behind.to->x - behind.from->x, behind.to->z - behind.from->z) -
                        std::atan2(before.to->x - before.from->x, before.to->z - before.from->z);
    constexpr double back = 0.02; // radians short of turning back, where no rounding has room
    if (std::abs(std::abs(std::remainder(turn, 2 * std::numbers::pi)) - std::numbers::pi) < back)
        return std::nullopt;
    return *before.corner * std::abs(std::tan(turn / 2));
}

/// The line behind the corner of an element: that of the last one of a closed contour is the first, which
/// follows the start point; that of an open one has none but its own.
const queries::OutlineElement& behind_corner(const queries::Outline& outline, std::size_t of) {
    const auto& elements = outline.elements;
    if (of + 1 < elements.size()) return elements[of + 1];
    const auto &end = elements.back().to, &start = elements.front().to;
    const bool closes = elements.size() > 2 && end && start && queries::distance(*end, *start) < rounding;
    return closes ? elements[1] : elements.back();
}

double rounded(double length) { return std::round(length * 1000) / 1000; }

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    for (const queries::Outline& outline : queries::turning_contours(analysis.program())) {
        for (std::size_t i = 0; i < outline.elements.size(); ++i) {
            const queries::OutlineElement& element = outline.elements[i];
            if (!element.corner || *element.corner == 0) continue;
            const queries::OutlineElement& behind = behind_corner(outline, i);
            const auto taken = taken_by(element, behind);
            for (const queries::OutlineElement* line : {&element, &behind}) {
                const auto length = length_of(*line);
                if (!taken || !length || *length == 0 || *taken <= *length + rounding) continue;
                reporter.report({analysis, element.corner_span}, element.corner_span,
                                *element.corner < 0 ? "plain" : "rounding",
                                {quoted(analysis.program(), element.corner_span),
                                 number_word(rounded(*taken)), number_word(rounded(*length))});
                break;
            }
        }
    }
}

} // namespace
} // namespace maclint::rules
