//! MAC727: a tolerance that stands inside the ABS of a difference.
#include "analyzer/dataflow/facts/comparison.hpp"
#include "analyzer/dataflow/facts/read.hpp"
#include "analyzer/dataflow/facts/store.hpp"
#include "analyzer/program/model.hpp"
#include "rules/numbers/tolerance_inside_abs_finder.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule tolerance_inside_abs{
    .code = "MAC727",
    .name = "tolerance-inside-abs",
    .summary = "A tolerance is taken from a difference before its amount is taken",
    .why = "ABS[a-b-0.01] is no distance with a tolerance: on one side of b the limit is 0.01 nearer, on the "
           "other "
           "0.01 farther. A check that is to take a small error takes it in one direction, and stops in the "
           "other.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .facts = dataflow::facts<dataflow::Comparison, dataflow::Read, dataflow::Store>(),
    .messages = {{"plain",
                  "Tolerance inside ABS: '{0}' shifts the difference by {1} before its amount is taken, so "
                  "the limit is "
                  "another on each side.",
                  "Add it to the amount, or to what that is compared with."},
                 {"stored",
                  "Tolerance inside ABS: '{0}' goes by the amount of '{2}', which {1} has shifted, so the "
                  "limit is another on each side.",
                  "Add it to the amount, or to what that is compared with."}},
    .bad = {{"fanuc", R"nc(
O0727(CHECK THE WAY)
#32=#5001
G91 G31 X20. F50.
G90
G53
IF[ABS[#5001-#32-.001]LT20.]GOTO803
M30
N803 #3000=3(HIT TOO EARLY)
)nc"},
            {"fanuc", R"nc(
O9727(CHECK THE BORE, X NOMINAL, E TOLERANCE)
IF[#8LE0]GOTO1
#30=#135-#24-#8
IF[ABS[#30]GT0]GOTO1
M99
N1 #3000=1(BORE NOT IN PLACE)
)nc"}},
    .good = {{"fanuc", R"nc(
O0727(CHECK THE WAY)
#32=#5001
G91 G31 X20. F50.
G90
G53
IF[[ABS[#5001-#32]+.001]LT20.]GOTO803
IF[ABS[#5001-#32-2.5]LT.1]GOTO803
M30
N803 #3000=3(HIT TOO EARLY)
)nc"},
             {"fanuc", R"nc(
O9727(CHECK THE BORE, X NOMINAL, E TOLERANCE)
IF[#8LE0]GOTO1
#30=ABS[#135-#24]-#8
IF[#30GT0]GOTO1
M99
N1 #3000=1(BORE NOT IN PLACE)
)nc"}},
    .sources = {"T"},
    .check = &check,
};

namespace {

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    const Program& program = analysis.program();
    for (const ShiftedDifference& shifted : find_shifted_differences(analysis)) {
        const Span span = program.expressions[shifted.side].span;
        Finding& finding = reporter.report(
            {analysis, shifted.effect, shifted.side}, span, shifted.is_stored ? "stored" : "plain",
            {quoted(program, span), quoted(program, shifted.tolerance), quoted(program, shifted.difference)});
        if (shifted.is_stored)
            finding.related.push_back({analysis.source(), shifted.difference, "the difference stands here"});
    }
}

} // namespace
} // namespace maclint::rules
