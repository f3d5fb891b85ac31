//! DIN241: a pocket is milled whose contour is not closed.
#include "analyzer/program/section_blocks.hpp"
#include "analyzer/program/word_lookup.hpp"
#include "analyzer/queries/contours/contour_names.hpp"
#include "analyzer/queries/contours/surface_contours.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule milled_contour_open{
    .code = "DIN241",
    .name = "milled-contour-open",
    .summary = "A pocket is milled whose contour is not closed",
    .why = "Pockets are milled in closed contours only: the control refuses one whose last element does not "
           "end where the first begins.",
    .severity = Severity::error,
    .precision = Precision::high,
    .needs = {Capability::sections},
    .messages = {{"plain",
                  "Open contour: '{0}' mills what line {1} begins, and '{2}' does not come back there.",
                  "Close the contour, or mill it with G840."}},
    .bad = {{"dinplus", R"nc(
FINISHED
N1 G0 X80 Z0
N2 G1 Z-40
FACE_C Z0
N3 G308 ID"WINDOW" P-5
N4 G100 XK10 YK0
N5 G101 XK26
N6 G101 YK16
N7 G101 XK10
N8 G309
MACHINING
N10 T1
N11 G197 S1200 G193 F0.05 M103
N12 G110 C0
N13 G845 ID"WINDOW" P2 U0.5 Q0 RB5
N14 M30
END
)nc"}},
    .good = {{"dinplus", R"nc(
FINISHED
N1 G0 X80 Z0
N2 G1 Z-40
FACE_C Z0
N3 G308 ID"WINDOW" P-5
N4 G100 XK10 YK0
N5 G101 XK26
N6 G101 YK16
N7 G101 XK10
N8 G101 YK0
N9 G309
MACHINING
N11 T1
N12 G197 S1200 G193 F0.05 M103
N13 G110 C0
N14 G845 ID"WINDOW" P2 U0.5 Q0 RB5
N15 M30
END
)nc"}},
    .sources = {"SEED-003:17415"},
    .check = &check,
};

namespace {

constexpr double rounding = 0.01; // mm: end points are written with two places or more
/// Roughing and finishing of pockets.
constexpr std::array pockets = {845.0, 846.0};

/// The contour that the block names by a number alone, or by the name of its level.
const queries::SurfaceContour* contour_of(const Program& program,
                                          const std::vector<queries::SurfaceContour>& contours,
                                          std::span<const Word> words) {
    const Word *name = find_word(words, "ID"), *number = find_word(words, "NS");
    if (find_word(words, "NE") != nullptr || (name == nullptr) == (number == nullptr)) return nullptr;
    const auto text = name != nullptr ? queries::text_of(program, *name) : std::nullopt;
    const auto wanted = number_of(number);
    const auto is_meant = [&](const queries::SurfaceContour& contour) {
        if (name != nullptr) return text && !contour.name.empty() && contour.name == *text;
        return wanted && std::ranges::any_of(contour.numbers, [&](std::int64_t one) {
                   return static_cast<double>(one) == *wanted;
               });
    };
    return std::ranges::count_if(contours, is_meant) == 1 ? &*std::ranges::find_if(contours, is_meant)
                                                          : nullptr;
}

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    const Program& program = analysis.program();
    const auto contours = queries::surface_contours(program);
    if (contours.empty()) return;
    for_each_running_block_with(program, "ID NS", [&](const BlockView& block, std::span<const Word> words) {
        const auto code = number_of(words, "G");
        if (!code || std::ranges::find(pockets, *code) == pockets.end()) return;
        const auto* contour = contour_of(program, contours, words);
        if (contour == nullptr || !contour->is_whole || !contour->start || contour->elements.empty()) return;
        const queries::OutlineElement& last = contour->elements.back();
        if (!last.to || queries::distance(*last.to, *contour->start) <= rounding) return;
        reporter.report({analysis, block.span}, block.span, "plain",
                        {quoted(program, block.span),
                         line_number(analysis.file(), contour->elements.front().block.begin),
                         quoted(program, last.block)});
    });
}

} // namespace
} // namespace maclint::rules
