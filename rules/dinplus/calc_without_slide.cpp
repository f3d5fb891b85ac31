//! DIN319: a variable counted once for each slide.
#include "analyzer/dataflow/domain/read_set.hpp"
#include "analyzer/program/block_view.hpp"
#include "analyzer/program/tables.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"

#include <algorithm>
#include <bit>
#include <string>
#include <variant>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule calc_without_slide{
    .code = "DIN319",
    .name = "calc-without-slide",
    .summary = "A block that names no slide counts a variable that all slides share",
    .why = "Each slide runs the block: what is added is added once for each of them.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .needs = {Capability::sections},
    .messages = {{"plain",
                  "Counted by every slide: '{0}' runs on {1} slides, and '{2}' is one for all of them.",
                  "Write the slide in front of the block, as in $1."}},
    .bad = {{"dinplus", R"nc(
PROGRAM HEAD
#SLIDE $1$2
MACHINING
N10 #g1=#g1+1
$1 N11 G4 F#g1
N99 M30
END
)nc"}},
    .good = {{"dinplus", R"nc(
PROGRAM HEAD
#SLIDE $1$2
MACHINING
$1 N10 #g1=#g1+1
$1 N11 G4 F#g1
N99 M30
END
)nc"}},
    .sources = {"SEED-003:18929"},
    .check = &check,
};

namespace {

/// The variable that the effect counts, where all channels have it in common; nothing for any other effect.
const Variable* shared_counter(const Program& program, const Effect& effect) {
    const auto* assign = std::get_if<Assign>(&effect.what);
    const auto* target = assign == nullptr ? nullptr : std::get_if<Variable>(&assign->target);
    if (target == nullptr || program.control->spaces[target->space].scope != Scope::retained) return nullptr;
    const auto read = dataflow::variables_of(program, assign->value).variables;
    return std::ranges::find(read, *target) == read.end() ? nullptr : target;
}

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    const Program& program = analysis.program();
    if (!program.has_several_channels()) return;
    for (ItemId item = 0; item < program.items.size(); ++item) {
        const auto* block = std::get_if<Block>(&program.items[item]);
        const Channels channels = program.channels_of(item);
        if (block == nullptr || (channels & (channels - 1U)) == 0) continue;
        for_each_effect_in(program, block->effects, [&](EffectId id) {
            const Effect& effect = program.effects[id];
            const Variable* counter = shared_counter(program, effect);
            if (counter == nullptr) return;
            reporter.report({analysis, id}, effect.span, "plain",
                            {quoted(program, effect.span), std::to_string(std::popcount(channels)),
                             program.spell(*counter)});
        });
    }
}

} // namespace
} // namespace maclint::rules
