//! Chooses the message for a loop that never ends.
#include "rules/flow/endless_loop_words.hpp"

#include "analyzer/program/tables.hpp"
#include "analyzer/queries/loops/loop_counter.hpp"
#include "analyzer/queries/loops/loop_exits.hpp"
#include "analyzer/queries/loops/set_again.hpp"
#include "rules/listed.hpp"
#include "rules/path.hpp"

#include <algorithm>

namespace maclint::rules {
namespace {

std::string list(const Program& program, const std::vector<Variable>& variables) {
    std::vector<std::string> names;
    for (const Variable variable : variables) names.push_back(program.spell(variable));
    return listed(names, " or ");
}

bool has_no_condition(const ProgramAnalysis& analysis, const dataflow::Loop& loop) {
    const flow::Region* region = queries::region_of(analysis, loop);
    return region != nullptr && region->region_kind == RegionKind::endless_loop;
}

/// A loop that something stops, and that no path leaves otherwise: what it counts in its own variables never
/// changes.
std::optional<EndlessLoopWords> until_it_is_stopped(const ProgramAnalysis& analysis,
                                                    const dataflow::Loop& loop) {
    if (loop.has_unknown_effects || !queries::is_never_left(analysis, loop)) return std::nullopt;
    const auto deciders = queries::unchanging_deciders(analysis, loop);
    const bool counts =
        deciders && !deciders->empty() && std::ranges::all_of(loop.exit_edges, [&](flow::EdgeId id) {
            return queries::asks_for_less_or_more(analysis.program(), *analysis.graph().edges[id].condition);
        });
    const auto is_own = [&](Variable variable) {
        return analysis.control().spaces[variable.space].scope == Scope::frame;
    };
    if (!counts || !std::ranges::all_of(*deciders, is_own)) return std::nullopt;
    return EndlessLoopWords{
        "until-stopped", {list(analysis.program(), *deciders)}, "and nothing has changed"};
}

} // namespace

std::optional<EndlessLoopWords> endless_loop_words(const ProgramAnalysis& analysis,
                                                   const dataflow::Loop& loop) {
    if (queries::is_endless_by_jumps(loop) || has_no_condition(analysis, loop) ||
        queries::is_in_endless_jumps(analysis, loop))
        return std::nullopt;
    if (loop.can_stop) return until_it_is_stopped(analysis, loop);
    const Program& program = analysis.program();
    const auto deciders = queries::unchanging_deciders(analysis, loop);
    if (!deciders) {
        if (const auto idle = queries::idle_condition(analysis, loop))
            return EndlessLoopWords{
                "idle", {quoted(program, program.expressions[*idle].span)}, "and nothing has changed"};
        if (const auto again = queries::set_again(analysis, loop))
            return EndlessLoopWords{"set-again",
                                    {quoted(program, program.expressions[again->condition].span),
                                     quoted(program, program.effects[again->store].span)},
                                    "and it is as before"};
        const auto condition = queries::condition_never_met(analysis, loop);
        const auto counter = queries::counter_of(analysis, loop);
        if (!condition || (counter && counter->clamps.empty())) return std::nullopt;
        return EndlessLoopWords{
            "never-met", {quoted(program, program.expressions[*condition].span)}, "and it is as before"};
    }
    if (deciders->empty() && !analysis.control().loops_left_by_jump) return std::nullopt;
    const std::string again = "and nothing has changed";
    if (deciders->empty()) return EndlessLoopWords{"no-exit", {}, again};
    const bool own_block = !loop.region && loop.body.size() <= 2;
    return EndlessLoopWords{own_block ? "own-block" : "unchanged", {list(program, *deciders)}, again};
}

} // namespace maclint::rules
