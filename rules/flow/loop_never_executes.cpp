//! MAC321: a loop that does not run, because its counter is as an earlier loop left it.
#include "analyzer/dataflow/facts/condition.hpp"
#include "analyzer/dataflow/facts/store.hpp"
#include "analyzer/queries/loops/loop_exits.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"
#include "rules/trace.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <variant>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule loop_never_executes{
    .code = "MAC321",
    .name = "loop-never-executes",
    .summary = "A loop never runs, because its counter is as the loop before has left it",
    .why = "The counter was not set back between two loops. The second one is passed over without a message, "
           "and "
           "what it was to machine stays as it is.",
    .severity = Severity::warning,
    .precision = Precision::very_high,
    .facts = dataflow::facts<dataflow::Condition, dataflow::Store>(),
    .data_flow = true,
    .messages = {{"plain", "Loop that never runs: at '{0}', {1} is as the loop on line {2} has left it.",
                  "Set {1} before the loop."}},
    .bad = {{"fanuc", R"nc(
O0321(TWO ROWS)
#1=0
WHILE[#1LT5]DO1
G90 G0 X#1
#1=#1+1
END1
WHILE[#1LT5]DO1
G0 Y#1
#1=#1+1
END1
M30
)nc"}},
    .good = {{"fanuc", R"nc(
O0321(TWO ROWS)
#1=0
WHILE[#1LT5]DO1
G90 G0 X#1
#1=#1+1
END1
#1=0
WHILE[#1LT5]DO1
G0 Y#1
#1=#1+1
END1
M30
)nc"}},
    .sources = {"SEED-002:470-486"},
    .check = &check,
};

namespace {

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

/// A variable that the condition asks for, and that the loop before counts.
struct Left {
    Variable variable;
    const dataflow::Loop* loop;
};

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

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    const Program& program = analysis.program();
    for (const dataflow::Condition& condition : analysis.facts().all<dataflow::Condition>()) {
        if (condition.truth.can_hold || !queries::is_loop_condition(analysis, condition)) continue;
        const Span span = program.expressions[condition.expression].span;
        const auto left = left_by_a_loop(analysis, span);
        if (!left) continue;
        Finding& finding = reporter.report(
            {analysis, condition}, span, "plain",
            {quoted(program, span), program.spell(left->variable),
             line_number(analysis.file(), queries::span_of_repetition(analysis, *left->loop).begin)});
        trace(finding, analysis, condition.node, "the loop is passed over here");
    }
}

} // namespace
} // namespace maclint::rules
