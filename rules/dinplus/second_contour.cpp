//! DIN204: an auxiliary contour that holds a second one.
#include "analyzer/program/section_blocks.hpp"
#include "analyzer/program/word_lookup.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"

#include <algorithm>
#include <optional>
#include <span>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule second_contour{
    .code = "DIN204",
    .name = "aux-contour-one-only",
    .summary = "An auxiliary contour begins a second time",
    .why = "The section holds one contour: cycles that ask for its name find the first one, or an error.",
    .severity = Severity::error,
    .precision = Precision::high,
    .needs = {Capability::sections},
    .messages = {{"plain", "Second contour: '{0}' begins another one, the section has one since line {1}.",
                  "Write a section AUXIL_CONTOUR of its own for it."}},
    .bad = {{"dinplus", R"nc(
AUXIL_CONTOUR ID"SEAT"
N1 G0 X60 Z0
N2 G1 Z-30
N3 G0 X80 Z-40
N4 G1 Z-60
MACHINING
N10 M30
END
)nc"}},
    .good = {{"dinplus", R"nc(
AUXIL_CONTOUR ID"SEAT"
N1 G0 X60 Z0
N2 G1 Z-30
AUXIL_CONTOUR ID"COLLAR"
N3 G0 X80 Z-40
N4 G1 Z-60
MACHINING
N10 M30
END
)nc"}},
    .sources = {"SEED-003:10196"},
    .check = &check,
};

namespace {

/// Whether a branch or a subprogram decides what the section describes.
bool has_branches(const Program& program, const Section& section) {
    bool found = false;
    for_each_block_with_effects(program, section.items, [&](const BlockView& block) {
        found |= std::ranges::any_of(program.effects_in(block.effects), [](const Effect& effect) {
            return std::holds_alternative<Call>(effect.what) ||
                   std::holds_alternative<RegionMark>(effect.what) ||
                   std::holds_alternative<UnreadableBlock>(effect.what);
        });
    });
    return found;
}

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    const Program& program = analysis.program();
    for (const Section& section : program.sections) {
        if (section.kind != "AUXIL_CONTOUR" || has_branches(program, section)) continue;
        std::optional<Offset> first; // start point
        for_each_block_of(program, section, [&](const BlockView& block, std::span<const Word> words) {
            if (number_of(words, "G") != 0 || block.skip_levels != 0) return;
            if (first)
                reporter.report({analysis, block.span}, block.span, "plain",
                                {quoted(program, block.span), line_number(analysis.file(), *first)});
            else
                first = block.span.begin;
        });
    }
}

} // namespace
} // namespace maclint::rules
