//! DIN217: an undercut in a corner whose second line is oblique.
#include "analyzer/program/section_blocks.hpp"
#include "analyzer/program/word_lookup.hpp"
#include "analyzer/queries/contours/turning_outline.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule undercut_before_slope{
    .code = "DIN217",
    .name = "undercut-before-slope",
    .summary = "An undercut stands in a corner whose second line is not parallel to X",
    .why = "Undercuts of G25 are for corners whose shoulder is parallel to X: in another one the control "
           "makes none, or stops.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .needs = {Capability::sections},
    .messages = {{"plain",
                  "Undercut before a slope: '{0}' lies in the corner to '{1}', which goes along X and Z.",
                  "Write the shoulder along X, or leave the undercut out."}},
    .bad = {{"dinplus", R"nc(
FINISHED
N1 G0 X0 Z0
N2 G1 X48
N3 G1 Z-30
N4 G25 H6
N5 G1 X70 Z-34
N6 G1 Z-60
MACHINING
N10 M30
END
)nc"}},
    .good = {{"dinplus", R"nc(
FINISHED
N1 G0 X0 Z0
N2 G1 X48
N3 G1 Z-30
N4 G25 H6
N5 G1 X70
N6 G1 Z-60
MACHINING
N10 M30
END
)nc"}},
    .sources = {"SEED-003:10909-10913"},
    .check = &check,
};

namespace {

constexpr double rounding = 0.001; // mm

bool is_known(const queries::OutlineElement& element) {
    return !element.is_arc && element.from && element.to;
}
bool runs_along_x(const queries::OutlineElement& line) {
    return std::abs(line.from->z - line.to->z) < rounding;
}
bool is_oblique(const queries::OutlineElement& line) {
    return !runs_along_x(line) && std::abs(line.from->x - line.to->x) >= rounding;
}

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    constexpr double undercut = 25;
    const Program& program = analysis.program();
    for (const queries::Outline& outline : queries::turning_contours(program))
        for_each_block_of(program, *outline.section,
                          [&](const BlockView& block, std::span<const Word> words) {
                              if (number_of(words, "G") != undercut || block.skip_levels != 0) return;
                              // The shoulder may be the line in front of it.
                              const queries::OutlineElement* before = outline.before(block.span.begin);
                              const queries::OutlineElement* next = outline.behind(block.span.begin);
                              if (before == nullptr || next == nullptr || !is_known(*before) ||
                                  !is_known(*next) || runs_along_x(*before) || !is_oblique(*next))
                                  return;
                              reporter.report({analysis, block.span}, block.span, "plain",
                                              {quoted(program, block.span), quoted(program, next->block)});
                          });
}

} // namespace
} // namespace maclint::rules
