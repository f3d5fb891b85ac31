//! DIN209: a finished part that its blank does not hold.
#include "analyzer/queries/contours/turning_outline.hpp"
#include "analyzer/queries/structure/sections.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"

#include <algorithm>
#include <optional>
#include <string>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule finished_outside_blank{
    .code = "DIN209",
    .name = "finished-outside-blank",
    .summary = "The finished part reaches beyond the blank",
    .why = "There is no material for it: cycles that start from the blank go wrong, and the part stays "
           "smaller than it is drawn.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .needs = {Capability::sections},
    .messages =
        {{"diameter", "Finished part outside the blank: '{0}' reaches diameter {1}, the blank has {2}.",
          "Correct the contour, or the diameter of the blank."},
         {"length", "Finished part outside the blank: '{0}' reaches Z{1}, the blank lies from Z{2} to Z{3}.",
          "Correct the contour, or the length or the right edge of the blank."},
         {"bore", "Finished part inside the bore: '{0}' reaches diameter {1}, the bore of the blank has {2}.",
          "Correct the contour, or the bore of the blank."}},
    .bad = {{"dinplus", R"nc(
BLANK
N1 G20 X60 Z80 K1
FINISHED
N2 G0 X0 Z0
N3 G1 X65
N4 G1 Z-40
MACHINING
N10 M30
END
)nc"},
            {"dinplus", R"nc(
BLANK
N1 G20 X60 Z80 K1
FINISHED
N2 G0 X0 Z0
N3 G1 X55
N4 G1 Z-90
MACHINING
N10 M30
END
)nc"}},
    .good = {{"dinplus", R"nc(
BLANK
N1 G20 X60 Z80 K1
FINISHED
N2 G0 X0 Z0
N3 G1 X60
N4 G1 Z-79
MACHINING
N10 M30
END
)nc"}},
    .sources = {"SEED-003:10183", "SEED-003:10500-10513"},
    .check = &check,
};

namespace {

void look_at(const ProgramAnalysis& analysis, const queries::Bar& bar, const queries::Outline& outline,
             Reporter& reporter) {
    constexpr double rounding = 0.001;
    for (const queries::OutlineElement& element : outline.elements) {
        if (!element.to) continue;
        const std::string block = quoted(analysis.program(), element.block);
        if (2 * element.to->x > bar.diameter + rounding)
            reporter.report({analysis, element.block}, element.block, "diameter",
                            {block, number_word(2 * element.to->x), number_word(bar.diameter)});
        else if (element.to->z > bar.right + rounding || element.to->z < bar.left - rounding)
            reporter.report(
                {analysis, element.block}, element.block, "length",
                {block, number_word(element.to->z), number_word(bar.left), number_word(bar.right)});
        else if (bar.bore > 0 && 2 * element.to->x < bar.bore - rounding)
            reporter.report({analysis, element.block}, element.block, "bore",
                            {block, number_word(2 * element.to->x), number_word(bar.bore)});
        else
            continue;
        return; // one finding a contour
    }
}

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    // Moves of the tool stand in the contour where the word between them is missing: that is told elsewhere.
    if (!queries::has_section(analysis.program(), SectionKind::Role::machining)) return;
    const auto outlines = queries::turning_contours(analysis.program());
    std::optional<queries::Bar> bar;
    for (const Section& section : analysis.program().sections) {
        if (section.kind == "BLANK") bar = queries::bar_of(analysis.program(), section);
        if (section.kind != "FINISHED" || !bar) continue;
        const auto outline = std::ranges::find(outlines, &section, &queries::Outline::section);
        if (outline != outlines.end()) look_at(analysis, *bar, *outline, reporter);
        bar.reset();
    }
}

} // namespace
} // namespace maclint::rules
