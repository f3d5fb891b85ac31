//! MAC210: a macro calculates with an argument that its callers leave out.
#include "analyzer/dataflow/facts/clobber.hpp"
#include "analyzer/dataflow/facts/comparison.hpp"
#include "analyzer/dataflow/facts/read.hpp"
#include "analyzer/dataflow/facts/store.hpp"
#include "analyzer/queries/calls/callers.hpp"
#include "analyzer/queries/calls/missing_arguments.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"
#include "rules/trace.hpp"

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule argument_not_passed{
    .code = "MAC210",
    .name = "argument-not-passed",
    .summary = "A macro calculates with an argument that every known call leaves out, and asks nowhere "
               "whether it was passed",
    .why = "The variable is vacant and counts as 0: a depth, a radius or a clearance of 0, without an alarm.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .needs = {Capability::vacancy},
    .yields_to = "MAC209",
    .facts = dataflow::facts<dataflow::Read, dataflow::Comparison, dataflow::Store, dataflow::Clobber>(),
    .data_flow = true,
    .messages = {{"left-out",
                  "{0} is vacant here and counts as 0: the call on line {1} of {2} leaves it out. "
                  "Pass it, or test {0} with EQ #0 first."}},
    .bad = {{"fanuc", R"nc(
O0210(PLATE)
G65 P9210 X10. Z-5. F100.
M30
O9210(DRILL, X Z R F)
IF[#24LT0]GOTO9
G0 X#24
G0 Z[#18+2.]
G1 Z#26 F#9
F100.
N9 M99
)nc"}},
    .good = {{"fanuc", R"nc(
O0210(PLATE)
G65 P9210 X10. Z-5. R0 F100.
M30
O9210(DRILL, X Z R F)
IF[#24LT0]GOTO9
G0 X#24
G0 Z[#18+2.]
G1 Z#26 F#9
F100.
N9 M99
)nc"}},
    .exemptions = {{&queries::exemptions::compared_somewhere,
                    "compared-somewhere",
                    "The program compares the argument somewhere, or asks whether it is there: its author "
                    "has thought of other values.",
                    {"fanuc", R"nc(
O0210(PLATE)
G65 P9210 Z-5.
M30
O9210(DRILL, Z R)
IF[#18GT10.]GOTO9
G90 G1 Z[#26+#18] F100.
M99
N9 #3000=1(R TOO HIGH)
)nc"}}},
    .sources = {"SEED-001:187", "ZAPP-ARG"},
    .check = &check,
};

namespace {

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    for (const queries::MissingArgument& missing : queries::find_missing_arguments(analysis)) {
        const Program& program = analysis.program();
        const ProgramAnalysis& calling = queries::calling_program(analysis, *missing.call);
        const std::string name = program.spell(missing.read->variable);
        const Offset call = calling.program().effects[missing.call->effect].span.begin;
        Finding& finding =
            reporter.report({analysis, *missing.read}, program.expressions[missing.read->expression].span,
                            "left-out", {name, line_number(calling.file(), call), calling.program().name});
        finding.path.push_back(
            related_at_effect(calling, missing.call->effect, "this call leaves " + name + " out"));
        trace(finding, analysis, missing.read->node, "and it is calculated with here");
    }
}

} // namespace
} // namespace maclint::rules
