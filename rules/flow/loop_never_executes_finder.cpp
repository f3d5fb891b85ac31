//! Between the end of a loop and a condition nothing sets the counter.
#include "rules/flow/loop_never_executes_finder.hpp"

#include "analyzer/dataflow/domain/read_set.hpp"
#include "analyzer/dataflow/facts/store.hpp"
#include "analyzer/queries/loops/loop_exits.hpp"

#include <algorithm>
#include <utility>
#include <variant>

namespace maclint::rules {
namespace {

/// Of the loops of the text that hold all of it the smallest; nullptr: none, or a program that begins again.
const dataflow::Loop* loop_around(const ProgramAnalysis& analysis, const dataflow::Loop& inner) {
    const dataflow::Loop* around = nullptr;
    for (const dataflow::Loop& loop : analysis.loops())
        if (loop.body.size() > inner.body.size() && queries::repeated_by(analysis, loop) &&
            (around == nullptr || loop.body.size() < around->body.size()) && loop.holds(inner.head) &&
            std::ranges::includes(loop.body, inner.body))
            around = &loop;
    return around;
}

bool is_set_outside(const ProgramAnalysis& analysis, const dataflow::Loop& inner,
                    const dataflow::Loop& around, Variable counter) {
    bool is_set = false;
    dataflow::for_each_in_body(around, analysis.facts().all<dataflow::Store>(),
                               [&](const dataflow::Store& store) {
                                   is_set |= store.variable == counter && !inner.holds(store.node);
                               });
    return is_set;
}

/// Whether the loop changes the bound only in steps that lead it to the counter: #32=#32-1 for #29LT#32.
bool only_comes_nearer(const ProgramAnalysis& analysis, const dataflow::Loop& around,
                       const queries::CounterTest& test) {
    const auto* load = std::get_if<Load>(&analysis.program().expressions[test.bound].node);
    if (load == nullptr || around.changes.clobbered(load->variable)) return false;
    const bool counts_up = test.stays == Operation::less || test.stays == Operation::less_equal;
    const bool counts_down = test.stays == Operation::greater || test.stays == Operation::greater_equal;
    if (!counts_up && !counts_down) return false;
    bool nearer = true;
    dataflow::for_each_in_body(
        around, analysis.facts().all<dataflow::Store>(), [&](const dataflow::Store& store) {
            if (!(store.variable == load->variable)) return;
            const auto amount = store.step ? store.step->amount.constant() : std::nullopt;
            nearer &= amount && *amount > 0 && counts_up == (store.step->operation == Operation::subtract);
        });
    return nearer;
}

bool may_let_it_run(const ProgramAnalysis& analysis, const dataflow::Loop& around,
                    const queries::CounterTest& test) {
    const dataflow::ReadSet set = dataflow::variables_of(analysis.program(), test.bound);
    const bool stays = set.closed && std::ranges::none_of(set.variables, [&](Variable variable) {
                           return around.changes.may_change(variable);
                       });
    return !stays && !only_comes_nearer(analysis, around, test);
}

/// The step of an earlier loop that stands before it, after which nothing sets the variable up to it.
const dataflow::Store* step_left(const ProgramAnalysis& analysis, Variable variable, Offset before) {
    const Program& program = analysis.program();
    const dataflow::Store* last = nullptr;
    for (const dataflow::Store& store : analysis.facts().all<dataflow::Store>())
        if (store.variable == variable && program.effects[store.effect].span.begin < before &&
            (last == nullptr ||
             program.effects[last->effect].span.begin < program.effects[store.effect].span.begin))
            last = &store;
    return last != nullptr && last->step ? last : nullptr;
}

/// The loop of the text that holds the step, and ends before the place.
const dataflow::Loop* loop_that_left(const ProgramAnalysis& analysis, const dataflow::Store& step,
                                     Offset before) {
    const Program& program = analysis.program();
    const auto found = std::ranges::find_if(analysis.loops(), [&](const dataflow::Loop& loop) {
        const flow::Region* region = queries::region_of(analysis, loop);
        return region != nullptr && region->close && program.effects[*region->close].span.end <= before &&
               loop.holds(step.node);
    });
    return found == analysis.loops().end() ? nullptr : &*found;
}

} // namespace

std::optional<Left> left_by_a_loop(const ProgramAnalysis& analysis, Span condition) {
    for (const Expression& expression : analysis.program().expressions) {
        const auto* load = std::get_if<Load>(&expression.node);
        if (load == nullptr || !condition.contains(expression.span.begin)) continue;
        const dataflow::Store* step = step_left(analysis, load->variable, condition.begin);
        const dataflow::Loop* loop =
            step == nullptr ? nullptr : loop_that_left(analysis, *step, condition.begin);
        if (loop != nullptr) return Left{load->variable, loop};
    }
    return std::nullopt;
}

std::vector<RunOnce> find_loops_run_once(const ProgramAnalysis& analysis) {
    std::vector<RunOnce> found;
    for (const dataflow::Loop& loop : analysis.loops()) {
        const bool tests_first = std::ranges::all_of(loop.exit_edges, [&](flow::EdgeId edge) {
            return analysis.graph().edges[edge].from == loop.head;
        });
        if (!loop.region || !tests_first) continue;
        auto counter = queries::counter_of(analysis, loop);
        if (!counter || counter->tests.size() != 1) continue;
        const dataflow::Loop* around = loop_around(analysis, loop);
        if (around == nullptr || around->changes.clobbered(counter->variable) ||
            is_set_outside(analysis, loop, *around, counter->variable) ||
            may_let_it_run(analysis, *around, counter->tests.front()))
            continue;
        found.push_back({&loop, around, std::move(*counter)});
    }
    return found;
}

} // namespace maclint::rules
