//! MAC322: a loop that only equality ends, which its counter steps over.
#include "analyzer/dataflow/facts/comparison.hpp"
#include "analyzer/dataflow/facts/store.hpp"
#include "analyzer/queries/calls/callers.hpp"
#include "rules/flow/loop_exit_only_by_equality_finder.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"
#include "rules/trace.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule loop_exit_only_by_equality{
    .code = "MAC322",
    .name = "loop-exit-only-by-equality",
    .summary = "A loop ends only where its counter is exactly a number that its steps pass over",
    .why = "The counter goes past the number and on for ever: the tool makes the same move again and again, "
           "further "
           "with every pass where the counter is part of it.",
    .severity = Severity::warning,
    .precision = Precision::very_high,
    .yields_to = "MAC711",
    .facts = dataflow::facts<dataflow::Store, dataflow::Comparison>(),
    .data_flow = true,
    .messages =
        {{"number",
          "Loop left only by equality: '{0}' goes from {1} in steps of {2} and is never {3}, so '{4}' does "
          "not end the loop.",
          "Ask whether the bound is passed."},
         {"passed",
          "Loop left only by equality: '{0}' goes from {1} in steps of {2} and is never {3}, which {5} "
          "passes, so '{4}' does not end the loop.",
          "Ask whether the bound is passed."}},
    .bad = {{"fanuc", R"nc(
O0322(PLUNGE)
#1=0
WHILE[#1NE5]DO1
G91 G1 Z-2. F100.
#1=#1+2
END1
M30
)nc"}},
    .good = {{"fanuc", R"nc(
O0322(PLUNGE)
#1=0
WHILE[#1LT5]DO1
G91 G1 Z-2. F100.
#1=#1+2
END1
#1=0
WHILE[#1NE6]DO1
G1 Z-2.
#1=#1+2
END1
M30
)nc"}},
    .sources = {"SEED-001:1050"},
    .check = &check,
};

namespace {

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    const Program& program = analysis.program();
    for (const MissedBound& missed : find_missed_bounds(analysis)) {
        const Span span = program.effects[missed.step->effect].span;
        const Span test = program.expressions[missed.test->expression].span;
        std::string call;
        if (missed.call) {
            const ProgramAnalysis& calling = queries::calling_program(analysis, *missed.call);
            call = place_in(calling, calling.program().effects[missed.call->effect].span);
        }
        Finding& finding =
            reporter.report({analysis, missed.step->effect}, span, missed.call ? "passed" : "number",
                            {quoted(program, span), number_word(missed.start), number_word(missed.amount),
                             number_word(missed.bound), quoted(program, test), call});
        finding.related.push_back({analysis.source(), test, "nothing else ends the loop"});
        trace(finding, analysis, missed.step->node, "the counter goes past the bound here");
    }
}

} // namespace
} // namespace maclint::rules
