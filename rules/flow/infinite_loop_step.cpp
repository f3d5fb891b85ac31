//! MAC320: the step of a loop's counter may be 0, or has the wrong sign.
#include "analyzer/dataflow/facts/comparison.hpp"
#include "analyzer/dataflow/facts/read.hpp"
#include "analyzer/dataflow/facts/store.hpp"
#include "analyzer/queries/loops/loop_counter.hpp"
#include "analyzer/queries/loops/loop_steps.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/flow/endless_step.hpp"
#include "rules/rule.hpp"

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule infinite_loop_step{
    .code = "MAC320",
    .name = "infinite-loop-step",
    .aliases = "DIN408",
    .summary =
        "The step that a loop advances by may be 0 or vacant, or has the wrong sign: the loop never ends",
    .why = "An argument that the caller left out counts as 0 in arithmetic. The control then repeats the "
           "same pass until somebody presses reset.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .facts = dataflow::facts<dataflow::Store, dataflow::Comparison, dataflow::Read>(),
    .data_flow = true,
    .messages = {{"vacant", "Endless loop: '{0}' changes nothing when {1} is left out or 0.",
                  "Reject both before the loop."},
                 {"passed-zero",
                  "Endless loop: '{0}' changes nothing for the call on line {1} of {2}, which passes 0.",
                  "Pass another value, and reject 0 before the loop."},
                 {"passed-sign",
                  "Endless loop: '{0}' leads away from the end of the loop for the call on line {1} of {2}.",
                  "Turn the sign of what it passes, of the step, or the comparison around."},
                 {"zero", "Endless loop: '{0}' changes nothing, because its step is 0.", "Correct the step."},
                 {"wrong-sign",
                  "Endless loop: '{0}' leads away from the end of the loop, which therefore never comes.",
                  "Turn the sign of the step or the comparison around."}},
    .bad = {{"fanuc", R"nc(
O9320(DEPTH PASSES, Z DEPTH K STEP)
IF[#26GE0]THEN#3000=1(Z MUST BE NEGATIVE)
#33=0
WHILE[#33GT#26]DO1
#33=#33-#6
G90 G1 Z#33
END1
M99
)nc"},
            {"fanuc", R"nc(
O0320(PLATE)
G65 P9321 Z-12. K0
M30
O9321(PASSES WITH ITS OWN FEED)
G65 P9322 Z#26 K#6
M99
O9322(DEPTH PASSES, Z DEPTH K STEP)
#33=0
WHILE[#33GT#26]DO1
#33=#33-#6
G90 G1 Z#33
END1
M99
)nc"},
            {"dinplus", R"nc(
MACHINING
N10 #l3=2
N20 WHILE #l3<10
N30 G0 X200 Z-#l3
N40 G1 Zi-15
N50 #l3=#l3-2
N60 ENDWHILE
N70 M30
END
)nc"}},
    .good = {{"fanuc", R"nc(
O9320(DEPTH PASSES, Z DEPTH K STEP)
IF[#26GE0]THEN#3000=1(Z MUST BE NEGATIVE)
IF[#6LE0]GOTO9
#33=0
WHILE[#33GT#26]DO1
#33=#33-#6
G90 G1 Z#33
END1
M99
N9 #3000=2(K MUST BE POSITIVE)
)nc"},
             {"dinplus", R"nc(
MACHINING
N10 #l3=2
N20 WHILE #l3<10
N30 G0 X200 Z-#l3
N40 G1 Zi-15
N50 #l3=#l3+2
N60 ENDWHILE
N70 M30
END
)nc"}},
    .sources = {"SEED-001:1028-1068"},
    .check = &check,
};

namespace {

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    for (const auto& [counter, fault] : queries::find_endless_counters(analysis)) {
        Finding& finding = report_step(analysis, reporter, counter, fault);
        for (const queries::CounterTest& test : counter.tests)
            finding.related.push_back({analysis.source(),
                                       analysis.program().expressions[test.comparison->expression].span,
                                       "this decides when the loop ends"});
    }
}

} // namespace
} // namespace maclint::rules
