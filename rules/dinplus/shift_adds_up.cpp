//! DIN418: a zero shift that adds up in a loop and is never taken back.
#include "analyzer/dataflow/loops.hpp"
#include "analyzer/program/section_blocks.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"

#include <algorithm>
#include <array>
#include <span>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule shift_adds_up{
    .code = "DIN418",
    .name = "g56-in-loop",
    .summary = "A zero shift adds up in a loop and is never taken back",
    .why = "Each round moves the zero point on, and after the loop it stays where the last round has left "
           "it: the next tool cuts beside the part.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .needs = {Capability::sections},
    .messages = {{"plain",
                  "Zero shift that adds up: each round of the loop adds '{0}', and no block behind "
                  "it sets the zero point anew.",
                  "Set it with G59 behind the loop, or in it."}},
    .bad = {{"dinplus", R"nc(
MACHINING
N1 T1
N2 #l1=0
N3 WHILE #l1<3
N4 G0 X60 Z2
N5 G56 Z-10
N6 #l1=#l1+1
N7 ENDWHILE
N8 G0 X60 Z2
N9 M30
END
)nc"}},
    .good = {{"dinplus", R"nc(
MACHINING
N1 T1
N2 #l1=0
N3 WHILE #l1<3
N4 G0 X60 Z2
N5 G56 Z-10
N6 #l1=#l1+1
N7 ENDWHILE
N8 G59 Z0
N9 M30
END
)nc"}},
    .sources = {"SEED-003:12793-12837"},
    .check = &check,
};

namespace {

constexpr double adds = 56;
constexpr std::array<double, 5> sets_anew = {51, 53, 54, 55, 59};

/// Whether the code stands in the part of the program that runs.
template<class Visit>
void for_each_code(const Program& program, const Visit& visit) {
    for_each_running_block_with(program, "G", [&](const BlockView& block, std::span<const Word> words) {
        for (const Word& word : words)
            if (const auto* code = std::get_if<Literal>(&word.value); code != nullptr && word.address == "G")
                visit(block, code->value);
    });
}

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    if (analysis.loops().empty()) return;
    const Program& program = analysis.program();
    Offset last_anew = 0;
    for_each_code(program, [&](const BlockView& block, double code) {
        if (std::ranges::find(sets_anew, code) != sets_anew.end()) last_anew = block.span.begin;
    });
    for_each_code(program, [&](const BlockView& block, double code) {
        if (code != adds) return;
        const auto node = analysis.graph().node_of(block.span);
        const bool repeats = node && std::ranges::any_of(analysis.loops(), [&](const dataflow::Loop& loop) {
                                 return loop.region && loop.holds(*node) &&
                                        analysis.graph().nodes[loop.head].part.begin > last_anew;
                             });
        if (repeats)
            reporter.report({analysis, block.span}, block.span, "plain", {quoted(program, block.span)});
    });
}

} // namespace
} // namespace maclint::rules
