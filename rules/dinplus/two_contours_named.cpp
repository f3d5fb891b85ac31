//! DIN705: NS and NE name blocks of two contours.
#include "analyzer/program/section_blocks.hpp"
#include "analyzer/program/word_lookup.hpp"
#include "analyzer/queries/contours/contour_blocks.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"

#include <algorithm>
#include <cstdint>
#include <string>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule two_contours_named{
    .code = "DIN705",
    .name = "contour-reference-other-group",
    .summary = "NS and NE name blocks of two contours",
    .why = "A cycle machines the elements from NS to NE of one contour: the control finds no way from one "
           "contour to another.",
    .severity = Severity::error,
    .precision = Precision::high,
    .needs = {Capability::block_references},
    .messages =
        {{"plain",
          "Two contours: '{0}' begins with N{1} on line {2}, and N{3} on line {4} stands in another section.",
          "Name blocks of one contour."}},
    .bad = {{"dinplus", R"nc(
BLANK
N1 G20 X60 Z80 K1
FINISHED
N2 G0 X0 Z0
N3 G1 X50
N4 G1 Z-40
AUXIL_CONTOUR ID"SEAT"
N5 G0 X40 Z0
N6 G1 Z-20
MACHINING
N10 T1
N11 G0 X62 Z2
N12 G810 NS3 NE6 P2
N13 M30
END
)nc"}},
    .good = {{"dinplus", R"nc(
BLANK
N1 G20 X60 Z80 K1
FINISHED
N2 G0 X0 Z0
N3 G1 X50
N4 G1 Z-40
AUXIL_CONTOUR ID"SEAT"
N5 G0 X40 Z0
N6 G1 Z-20
MACHINING
N10 T1
N11 G0 X62 Z2
N12 G810 NS3 NE4 P2
N13 M30
END
)nc"}},
    .sources = {"SEED-003:10203", "SEED-003:2827"},
    .check = &check,
};

namespace {

const Section* section_of(const NumberedBlock& block) {
    return section_at(*block.program, block.number_span.begin);
}

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    const Program& program = analysis.program();
    for_each_running_block_with(program, "NE", [&](const BlockView& view, std::span<const Word> words) {
        const auto from = number_of(words, "NS"), to = number_of(words, "NE");
        if (!from || !to) return;
        const auto first = queries::find_contour_block(analysis.file(), *from);
        const auto last = queries::find_contour_block(analysis.file(), *to);
        if (!first || !last || section_of(*first) == section_of(*last)) return;
        reporter.report({analysis, view.span}, view.span, "plain",
                        {quoted(program, view.span), number_word(*from),
                         line_number(analysis.file(), first->number_span.begin), number_word(*to),
                         line_number(analysis.file(), last->number_span.begin)});
    });
}

} // namespace
} // namespace maclint::rules
