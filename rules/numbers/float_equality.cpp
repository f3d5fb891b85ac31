//! MAC710: EQ or NE between numbers that rounding has touched.
#include "analyzer/dataflow/facts/comparison.hpp"
#include "analyzer/dataflow/facts/store.hpp"
#include "analyzer/queries/loops/inexact_counters.hpp"
#include "analyzer/queries/values/origins.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/numbers/float_equality_comparisons_finder.hpp"
#include "rules/numbers/float_equality_sums_finder.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"
#include "rules/trace.hpp"

#include <utility>
#include <vector>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule float_equality{
    .code = "MAC710",
    .name = "float-equality",
    .aliases = "DIN327",
    .summary = "A result that has been rounded is compared with EQ or NE: 0.002*1000 need not be 2",
    .why =
        "Both numbers look the same on the display, and yet the last pass is left out, or the loop goes on.",
    .severity = Severity::warning,
    .severity_elsewhere = {{"dinplus", Severity::note}},
    .precision = Precision::high,
    .facts = dataflow::facts<dataflow::Comparison, dataflow::Store>(),
    .data_flow = true,
    .messages =
        {{"equal",
          "Equality of computed numbers: '{0}' may be false by mistake: '{1}' is rounded (line {2}).",
          "Ask whether the ABS of the difference is less than 0.001."},
         {"not-equal",
          "Equality of computed numbers: '{0}' may be true by mistake: '{1}' is rounded (line {2}).",
          "Ask whether the ABS of the difference is 0.001 or more."},
         {"distance",
          "Distance of exactly 0: in '{0}' the last digit of a measured or calculated number decides.",
          "Compare '{1}' with a tolerance, as 0.001."},
         {"touched",
          "Equality of a place: '{0}' is true only where '{1}' is the other number to its last digit.",
          "Compare the ABS of the difference with a tolerance, as 0.01."},
         {"sum-equal", "Equality of a sum: '{0}' may be false when the steps added to {1} have decimals.",
          "Ask whether the ABS of the difference is less than 0.001."},
         {"sum-not-equal",
          "Equality of a sum: '{0}' may stay true when the steps added to {1} have decimals.",
          "Ask whether the ABS of the difference is 0.001 or more."}},
    .bad = {{"fanuc", R"nc(
O9710(HALF A TURN, A ANGLE)
#33=#1/3
IF[#33EQ60]GOTO9
G90 G0 X#33
N9 M99
)nc"},
            {"dinplus", R"nc(
MACHINING
N10 INPUT("Taper",#l1)
N20 #l3=#l1/7
N30 IF #l3==1.2
N40 THEN
N50 PRINT("Steep taper")
N60 ENDIF
N70 M30
END
)nc"}},
    .good = {{"fanuc", R"nc(
O9710(HALF A TURN, A ANGLE)
#33=#1/3
IF[ABS[#33-60]LT0.001]GOTO9
G90 G0 X#33
N9 M99
)nc"},
             {"dinplus", R"nc(
MACHINING
N10 INPUT("Taper",#l1)
N20 #l3=#l1/7
N30 IF ABS(#l3-1.2)<0.001
N40 THEN
N50 PRINT("Steep taper")
N60 ENDIF
N70 M30
END
)nc"}},
    .exemptions = {{&exemptions::whole_number_asked_for,
                    "asks-for-a-whole-number",
                    "A number is compared with itself without its decimals: it asks whether it is whole.",
                    {"fanuc", R"nc(
O9710(GRID, X)
#1=#24*0.3
IF[#1EQFIX[#1]]GOTO1
G91 G0 X#1
N1 M99
)nc"}},
                   {&exemptions::copy_asked_for,
                    "asks-for-a-copy",
                    "A block sets the one side to the other: the comparison asks whether that has happened.",
                    {"fanuc", R"nc(
O9710(LEVELS, I DEPTH Q STEP)
#14=0
N1 #14=#14+#17
IF[#14GT#4]THEN#14=#4
G90 G1 Z-#14 F100.
IF[#14EQ#4]GOTO2
GOTO1
N2 M99
)nc"}}},
    .sources = {"SEED-001:306-314", "HAAS-LA", "MITSU-326"},
    .check = &check,
};

namespace {

void report(const ProgramAnalysis& analysis, Reporter& reporter, const dataflow::Comparison& comparison,
            const InexactSide& inexact) {
    using Why = InexactSide::Why;
    const auto& program = analysis.program();
    const Span span = program.expressions[comparison.expression].span;
    std::vector<std::string> words{quoted(program, span),
                                   quoted(program, program.expressions[inexact.side].span)};
    const bool equal = comparison.operation == Operation::equal;
    std::string_view id = inexact.why == Why::distance ? "distance" : equal ? "equal" : "not-equal";
    if (inexact.why == Why::touched) id = "touched";
    if (inexact.why == Why::sum) id = equal ? "sum-equal" : "sum-not-equal";
    if (inexact.why == Why::rounded)
        words.push_back(
            line_number(analysis.file(), queries::span_of_origin(analysis, inexact.rounding).begin));
    Finding& finding = reporter.report({analysis, comparison}, span, id, std::move(words));
    finding.same_cause = "node " + std::to_string(comparison.node); // two in one condition
    const auto node = comparison.node;
    if (inexact.why == Why::rounded)
        trace(finding, analysis, inexact.rounding, "the result is rounded here", node, "and compared here");
    else if (inexact.sum == nullptr)
        trace(finding, analysis, node,
              inexact.why == Why::touched ? "the place is compared here" : "the distance is compared with 0");
    else
        trace(finding, analysis, inexact.sum->node,
              related_at_effect(analysis, inexact.sum->effect, "a step is added in every pass"), node,
              "and the sum is compared here");
}

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    const auto of_counters = queries::tests_of(queries::find_inexact_counters(analysis));
    const Sums sums = find_sums(analysis);
    for (const dataflow::Comparison& comparison : analysis.facts().all<dataflow::Comparison>()) {
        if (comparison.operation != Operation::equal && comparison.operation != Operation::not_equal)
            continue;
        const auto inexact = inexact_side(analysis, sums, comparison);
        if (inexact && !of_counters.contains(&comparison)) report(analysis, reporter, comparison, *inexact);
    }
}

} // namespace
} // namespace maclint::rules
