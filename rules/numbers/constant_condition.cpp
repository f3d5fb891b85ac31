//! MAC718: a condition that always holds or never does.
#include "analyzer/dataflow/facts/condition.hpp"
#include "analyzer/queries/conditions.hpp"
#include "analyzer/queries/deliberate_conditions.hpp"
#include "analyzer/queries/loop_exits.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"
#include "rules/trace.hpp"

#include <optional>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule constant_condition{
    .code = "MAC718",
    .name = "constant-condition",
    .aliases = "DIN405",
    .summary = "A condition is always true or never, because of what the program did before",
    .why = "Blocks run that should have been left out, or never run. Often another variable was "
           "meant, or an earlier test already went away with the case.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .facts = dataflow::facts<dataflow::Condition, dataflow::Comparison, dataflow::Store>(),
    .data_flow = true,
    .messages = {{"never", "'{0}' is never true here. Correct the condition, or remove what it guards."},
                 {"always", "'{0}' is always true here. Correct the condition, or remove it."}},
    .bad = {{"fanuc", R"nc(
O9718(LEVELS, K LEVEL)
IF[#6GT5]GOTO1
IF[#6GT10]GOTO2
G90 G0 Z0
M99
N1 G90 G0 Z10.
M99
N2 G90 G0 Z20.
M99
)nc"},
            {"dinplus", R"nc(
MACHINING
N10 INPUT("Diameter",#l1)
N20 IF #l1>50
N30 THEN
N40 #l3=0.4
N50 ELSE
N60 #l3=0.25
N70 IF #l1>80
N80 THEN
N90 #l3=0.5
N100 ENDIF
N110 ENDIF
N120 G95 F#l3
N130 M30
END
)nc"},
            {"dinplus", R"nc(
MACHINING
N10 WHILE 1==1
N20 G0 X10
N30 ENDWHILE
N40 M30
END
)nc"}},
    .good = {{"fanuc", R"nc(
O9718(LEVELS, K LEVEL)
IF[#6GT10]GOTO2
IF[#6GT5]GOTO1
G90 G0 Z0
M99
N1 G90 G0 Z10.
M99
N2 G90 G0 Z20.
M99
)nc"},
             {"dinplus", R"nc(
MACHINING
N10 INPUT("Diameter",#l1)
N20 IF #l1>50
N30 THEN
N40 #l3=0.4
N50 ELSE
N60 #l3=0.25
N70 IF #l1>30
N80 THEN
N90 #l3=0.3
N100 ENDIF
N110 ENDIF
N120 G95 F#l3
N130 M30
END
)nc"}},
    .sources = {"T"},
    .check = &check,
};

namespace {

bool is_defect(const ProgramAnalysis& analysis, const dataflow::Condition& condition,
               const queries::DeliberateConditions& deliberate) {
    // Where a jump can leave it, a loop without an exit is MAC319's.
    if (condition.truth.can_hold && queries::is_loop_condition(analysis, condition))
        return queries::never_ends(analysis, condition);
    if (queries::tests_any_vacancy(analysis.program(), condition.expression))
        return false; // MAC222's and MAC228's
    return !deliberate.may_be_meant(condition);
}

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    const Program& program = analysis.program();
    if (analysis.regions().balance_unknown) return; // a loop that cannot be read may repeat the block
    std::optional<queries::DeliberateConditions> deliberate; // most programs have no such condition
    for (const dataflow::Condition& condition : analysis.facts().all<dataflow::Condition>()) {
        const dataflow::Truth truth = condition.truth;
        if (truth.can_hold == truth.can_fail) continue;
        if (!deliberate) deliberate.emplace(analysis);
        if (!is_defect(analysis, condition, *deliberate)) continue;
        const Span span = program.expressions[condition.expression].span;
        Finding& finding = reporter.report({analysis, condition}, span, truth.can_hold ? "always" : "never",
                                           {quoted(program, span)});
        trace(finding, analysis, condition.node, truth.can_hold ? "it is always true" : "it is never true");
    }
}

} // namespace
} // namespace maclint::rules
