//! Looks at callers, other exits and arguments of a program that runs off its end.
#include "analyzer/queries/calls/expected_ends.hpp"

#include "analyzer/dataflow/facts/read.hpp"
#include "analyzer/program/block_view.hpp"
#include "analyzer/program/tables.hpp"
#include "analyzer/queries/calls/callers.hpp"
#include "analyzer/queries/modal/saved_state.hpp"
#include "analyzer/queries/structure/sections.hpp"
#include "analyzer/queries/values/copies.hpp"
#include "analyzer/source/budget.hpp"
#include "analyzer/workspace/written_as_macro.hpp"

#include <algorithm>

namespace maclint::queries {
namespace {

/// By a block that is skipped or unreadable; whether END closes a called file the manual does not say.
bool may_return_otherwise(const Program& program) {
    const auto last = last_block(program);
    bool may =
        !last || last->skip_levels != 0 || (!program.local && has_section(program, SectionKind::Role::end));
    for_each_effect(program, [&](EffectId id) {
        const auto* block = std::get_if<UnreadableBlock>(&program.effects[id].what);
        may |= block != nullptr && block->may_call_or_return;
    });
    return may;
}

/// A program that is not there may end in an alarm, or the part.
bool ends_with_unknown_call(const ProgramAnalysis& analysis, const flow::Exit& exit) {
    return std::ranges::any_of(analysis.calls(), [&](const CallSite& site) {
        return !site.target && analysis.graph().node_of(site.effect) == exit.node;
    });
}

/// Of those that are no alarm.
const flow::Exit* find_other_exit(const ProgramAnalysis& analysis) {
    const auto& exits = analysis.graph().exits;
    const auto leaves = [&](const flow::Exit& exit) {
        return exit.effect && exit.kind != flow::ExitKind::alarm && analysis.data().reached(exit.node);
    };
    const auto found = std::ranges::find_if(exits, leaves);
    return found == exits.end() ? nullptr : &*found;
}

const dataflow::Store* find_save_put_back(const ProgramAnalysis& analysis) {
    for (const dataflow::Store* save : saves_of(analysis))
        if (any_within_budget(analysis.facts().all<dataflow::Read>(), [&](const dataflow::Read& read) {
                return read.use == dataflow::Use::word && store_of(analysis, read.value) == save;
            }))
            return save;
    return nullptr;
}

/// The last block that does anything; 0 where none does.
Offset last_block_with_words(const Program& program) {
    Offset last = 0;
    const auto note = [&](const BlockView& block, const auto&...) {
        last = std::max(last, block.span.begin);
    };
    for_each_block_with_words(
        program, [](const WordSummary&) { return true; }, note);
    for_each_block_with_effects(program, note);
    return last;
}

/// `M#850` in the last block that does anything, which may be M30 or M99.
bool ends_with_computed_function(const ProgramAnalysis& analysis) {
    const Program& program = analysis.program();
    const std::string_view address = analysis.control().functions.address;
    const Offset last = last_block_with_words(program);
    bool computed = false;
    for_each_block_with_words(
        program, [](const WordSummary&) { return false; }, // plain blocks compute nothing
        [&](const BlockView& block, std::span<const Word> words, const auto&...) {
            computed |=
                block.span.begin == last && std::ranges::any_of(words, [&](const Word& word) {
                    return word.address == address && std::holds_alternative<ExpressionId>(word.value);
                });
        });
    return computed;
}

} // namespace

bool may_end_otherwise(const ProgramAnalysis& analysis, const flow::Exit& past_end) {
    return may_return_otherwise(analysis.program()) || ends_with_unknown_call(analysis, past_end) ||
           ends_with_computed_function(analysis);
}

std::optional<ExpectedEnd> find_expected_end(const ProgramAnalysis& analysis, const flow::Exit& past_end) {
    const Program& program = analysis.program();
    if (may_return_otherwise(program) || ends_with_computed_function(analysis)) return std::nullopt;
    if (const Caller* caller = find_reached_caller(analysis)) return caller;
    if (!analysis.control().sections.empty() || ends_with_unknown_call(analysis, past_end))
        return std::nullopt;
    if (const flow::Exit* other = find_other_exit(analysis)) return other;
    if (const auto argument = find_macro_argument(program)) return WrittenAsMacro{*argument};
    if (const dataflow::Store* save = find_save_put_back(analysis)) return KeepsState{save};
    return std::nullopt;
}

} // namespace maclint::queries
