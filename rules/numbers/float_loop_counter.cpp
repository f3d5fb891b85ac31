//! MAC711: a loop counts in steps that binary arithmetic cannot hold.
#include "analyzer/dataflow/facts/comparison.hpp"
#include "analyzer/dataflow/facts/store.hpp"
#include "analyzer/queries/loops/inexact_counters.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"
#include "rules/trace.hpp"

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule float_loop_counter{
    .code = "MAC711",
    .name = "float-loop-counter",
    .summary = "A loop advances by a step that binary arithmetic cannot hold: the last pass is "
               "missing or comes twice",
    .why = "Ten steps of 0.1 are not 1. Whether the last pass runs depends on the control, and on "
           "the numbers of the day.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .facts = dataflow::facts<dataflow::Store, dataflow::Comparison>(),
    .data_flow = true,
    .messages = {{"step",
                  "Rounded loop counter: '{0}' adds a rounding error in every pass, so the last pass by "
                  "'{1}' may be missing or come once too often.",
                  "Count whole passes, or add half a step to the bound."},
                 {"never-met",
                  "Rounded loop counter: '{0}' adds a rounding error in every pass, so the counter may never "
                  "be exactly the bound of '{1}'.",
                  "Ask whether the bound is passed, not whether it is met."}},
    .bad = {{"fanuc", R"nc(
O9711(ROWS)
#33=0
WHILE[#33LE1]DO1
G90 G0 X#33
#33=#33+0.1
END1
M99
)nc"},
            {"dinplus", R"nc(
MACHINING
N10 #l4=0
N20 WHILE #l4<=3
N30 G1 X50 Z-#l4
N40 #l4=#l4+0.1
N50 ENDWHILE
N60 M30
END
)nc"}},
    .good = {{"fanuc", R"nc(
O9711(ROWS)
#33=0
WHILE[#33LE10]DO1
G90 G0 X[#33/10]
#33=#33+1
END1
M99
)nc"},
             {"dinplus", R"nc(
MACHINING
N10 #l4=0
N20 WHILE #l4<=30
N30 G1 X50 Z-#l4/10
N40 #l4=#l4+1
N50 ENDWHILE
N60 M30
END
)nc"}},
    .exemptions = {{&queries::exemptions::tolerance_in_the_bound,
                    "tolerance-in-the-bound",
                    "The bound adds a number smaller than a step: somebody has thought of rounding.",
                    {"fanuc", R"nc(
O9711(ROWS, X)
#1=0
WHILE[#1LE[#24+0.001]]DO1
G90 G1 X#1 F100.
#1=#1+0.1
END1
M99
)nc"}},
                   {&queries::exemptions::counter_held_at_a_limit,
                    "held-at-a-limit",
                    "The loop sets the counter to its limit when it is beyond: the last pass comes, whatever "
                    "is rounded.",
                    {"fanuc", R"nc(
O9711(ROWS, X)
#1=0
WHILE[#1LT#24]DO1
#1=#1+0.1
IF[#1GT#24]THEN#1=#24
G90 G1 X#1 F100.
END1
M99
)nc"}}},
    .sources = {"SEED-001:306-314"},
    .check = &check,
};

namespace {

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    const Program& program = analysis.program();
    for (const queries::InexactCounter& counter : queries::find_inexact_counters(analysis)) {
        const dataflow::Store& step = *counter.step;
        const Span span = program.effects[step.effect].span;
        const Span decides = program.expressions[counter.decisive.comparison->expression].span;
        Finding& finding =
            reporter.report({analysis, step.effect}, span, counter.must_meet() ? "never-met" : "step",
                            {quoted(program, span), quoted(program, decides)});
        if (step.step->amount.rounding != 0)
            trace(finding, analysis, step.step->amount.rounding, "the step is rounded here", step.node,
                  "and added in every pass");
        else
            trace(finding, analysis, step.node, "the step is added in every pass");
        finding.related.push_back({analysis.source(), decides, "this decides whether there is another pass"});
    }
}

} // namespace
} // namespace maclint::rules
