//! MAC321: a loop that does not run, because its counter is as a loop has left it.
#include "analyzer/dataflow/facts/comparison.hpp"
#include "analyzer/dataflow/facts/condition.hpp"
#include "analyzer/dataflow/facts/store.hpp"
#include "analyzer/queries/loops/loop_exits.hpp"
#include "rules/flow/loop_never_executes_finder.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"
#include "rules/trace.hpp"

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule loop_never_executes{
    .code = "MAC321",
    .name = "loop-never-executes",
    .summary =
        "A loop never runs, or only in the first round of the loop around it, because its counter is as "
        "a loop has left it",
    .why =
        "The counter was not set back between two loops, or between two rounds of the outer one. The loop is "
        "passed over without a message, and what it was to machine stays as it is.",
    .severity = Severity::warning,
    .precision = Precision::very_high,
    .facts = dataflow::facts<dataflow::Comparison, dataflow::Condition, dataflow::Store>(),
    .data_flow = true,
    .messages = {{"plain", "Loop that never runs: at '{0}', {1} is as the loop on line {2} has left it.",
                  "Set {1} before the loop."},
                 {"inner",
                  "Loop that runs only in the first round of the loop on line {2}: at '{0}', {1} is as this "
                  "loop has left it.",
                  "Set {1} in the loop on line {2}, before '{0}'."}},
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
)nc"},
            {"fanuc", R"nc(
O0321(ROWS OF HOLES)
#1=0
#2=0
WHILE[#1LT3]DO1
WHILE[#2LT5]DO2
G81 X[#2*10.] Y[#1*10.] Z-5. R2. F100
#2=#2+1
END2
#1=#1+1
END1
G80
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

void check_inner(const ProgramAnalysis& analysis, Reporter& reporter) {
    const Program& program = analysis.program();
    for (const RunOnce& found : find_loops_run_once(analysis)) {
        const ExpressionId condition = found.counter.tests.front().comparison->expression;
        const Span span = program.expressions[condition].span;
        Finding& finding = reporter.report(
            {analysis, condition}, span, "inner",
            {quoted(program, span), program.spell(found.counter.variable),
             line_number(analysis.file(), queries::span_of_repetition(analysis, *found.around).begin)});
        trace_round(finding, analysis, *found.around, "comes to the loop again");
    }
}

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    const Program& program = analysis.program();
    check_inner(analysis, reporter);
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
