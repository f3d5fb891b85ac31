//! MAC604: an argument that nothing checks decides when a loop ends.
#include "analyzer/dataflow/facts/comparison.hpp"
#include "analyzer/dataflow/facts/read.hpp"
#include "analyzer/dataflow/facts/store.hpp"
#include "rules/operand_risk.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"
#include "rules/trace.hpp"
#include "rules/variables/missing_argument_validation_finder.hpp"

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule missing_argument_validation{
    .code = "MAC604",
    .name = "missing-argument-validation",
    .summary =
        "A loop counts up or down to an argument, and nothing checks whether it was passed and what it is",
    .why = "Left out, or with a sign or a decimal point missing, it makes the loop end at once or go on far "
           "beyond: no pass is cut, or hundreds. A test in front of the loop turns that into an alarm.",
    .severity = Severity::note,
    .precision = Precision::high,
    .needs = {Capability::vacancy},
    .yields_to = "MAC209 MAC210 MAC221",
    .facts = dataflow::facts<dataflow::Comparison, dataflow::Read, dataflow::Store>(),
    .data_flow = true,
    .messages =
        {{"left-out",
          "Loop bound missing: {2} goes on to {1} in '{0}', which the call on line {3} of {4} leaves out.",
          "Pass it, or check it before the loop."},
         {"others-checked",
          "Loop bound unchecked: the program checks {3}, but not {1}, to which {2} goes on in '{0}'.",
          "Check it before the loop."},
         {"unchecked", "Loop bound unchecked: nothing checks {1}, to which {2} goes on in '{0}'.",
          "Check it before the loop."}},
    .bad = {{"fanuc", R"nc(
O9604(GROOVE, Z DEPTH Q STEP)
IF[#17LE0]THEN#3000=1(Q MUST BE POSITIVE)
#33=0
WHILE[#33GT#26]DO1
#33=#33-#17
G90 G1 Z#33
END1
M99
)nc"}},
    .good = {{"fanuc", R"nc(
O9604(GROOVE, Z DEPTH Q STEP)
IF[#17LE0]THEN#3000=1(Q MUST BE POSITIVE)
IF[#26GE0]THEN#3000=2(Z MUST BE NEGATIVE)
#33=0
WHILE[#33GT#26]DO1
#33=#33-#17
G90 G1 Z#33
END1
M99
)nc"}},
    .exemptions = {{&exemptions::search_in_a_table,
                    "search-in-a-table",
                    "Another test ends the loop at a number: it goes through a table, and asks whether it "
                    "has found the argument.",
                    {"fanuc", R"nc(
O9604(FIND, T TOOL)
#1=1
WHILE[#1LE24]DO1
IF[#1EQ#20]GOTO2
#1=#1+1
END1
#3000=1(NO SUCH TOOL)
N2 #100=#1
M99
)nc"}}},
    .sources = {"SEED-002:331"},
    .check = &check,
};

namespace {

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    const Program& program = analysis.program();
    for (const UncheckedBound& bound : unchecked_bounds(analysis)) {
        const Span span = program.expressions[bound.test->expression].span;
        Finding& finding = report_risk(analysis, bound.risk, {analysis, *bound.read}, span,
                                       {quoted(program, span), with_letter(analysis, bound.read->variable),
                                        program.spell(bound.counter)},
                                       reporter);
        trace(finding, analysis, bound.read->node, "the loop goes on or ends here");
    }
}

} // namespace
} // namespace maclint::rules
