//! MAC726: a position is compared without the tolerance that the program's other comparisons have.
#include "analyzer/dataflow/facts/comparison.hpp"
#include "rules/numbers/missing_tolerance_finder.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule missing_tolerance{
    .code = "MAC726",
    .name = "missing-tolerance",
    .summary = "After a move a position is compared without the tolerance that other comparisons of the "
               "program have",
    .why = "Where the axis has come to the end of its move, the position and what the program calculates for "
           "it differ by rounding alone: without a tolerance this decides whether the probe has touched.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .facts = dataflow::facts<dataflow::Comparison>(),
    .messages = {{"exact",
                  "Tolerance missing: '{0}' compares a position with what is calculated for it, where '{1}' "
                  "on line {2} allows for {3}.",
                  "Allow for {3} here, too."}},
    .bad = {{"fanuc", R"nc(
O9726(PROBE, X WAY Z DEPTH F FEED)
#32=#4109
G31 X#24 F#9
IF[#5001GT[#1+#24-0.001]]GOTO9
G31 Z[#3-#26]
IF[#5003LT[#3-#26]]GOTO9
F#32
M99
N9 #3000=1(NO CONTACT)
)nc"}},
    .good = {{"fanuc", R"nc(
O9726(PROBE, X WAY Z DEPTH F FEED)
#32=#4109
G31 X#24 F#9
IF[#5001GT[#1+#24-0.001]]GOTO9
G31 Z[#3-#26]
IF[#5003LT[#3-#26+0.001]]GOTO9
F#32
M99
N9 #3000=1(NO CONTACT)
)nc"}},
    .sources = {"T"},
    .check = &check,
};

namespace {

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    const Program& program = analysis.program();
    for (const MissingTolerance& missing : find_missing_tolerances(analysis)) {
        const Span span = program.expressions[missing.exact->expression].span;
        const Span other = program.expressions[missing.tolerant->expression].span;
        Finding& finding = reporter.report({analysis, *missing.exact}, span, "exact",
                                           {quoted(program, span), quoted(program, other),
                                            line_number(analysis.file(), other.begin),
                                            quoted(program, program.expressions[missing.tolerance].span)});
        finding.same_cause = program.name + " " + line_number(analysis.file(), other.begin);
        finding.related.push_back({analysis.source(), other, "this comparison has a tolerance"});
    }
}

} // namespace
} // namespace maclint::rules
