//! MAC214: what a special case sets is set again before anything reads it.
#include "analyzer/dataflow/facts/read.hpp"
#include "analyzer/dataflow/facts/store.hpp"
#include "analyzer/queries/values/dead_stores.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"
#include "rules/trace.hpp"

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule overwritten_conditional{
    .code = "MAC214",
    .name = "overwritten-conditional",
    .summary = "What an IF sets in a special case is replaced in every case before anything reads it",
    .why = "The special case is lost: the program runs as if its condition had never been true.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .facts = dataflow::facts<dataflow::Store, dataflow::Read>(),
    .data_flow = true,
    .messages = {{"lost",
                  "Special case lost: '{0}', which depends on '{1}', is replaced by '{2}' on line {3} "
                  "before anything reads {4}.",
                  "Put the special case after line {3}, or jump over that line."}},
    .bad = {{"fanuc", R"nc(
O9214(ARC, S ANGLE)
IF[#19EQ0]THEN#33=360.
#33=#19
G0 C#33
M99
)nc"},
            {"dinplus", R"nc(
MACHINING
N10 INPUT("Length",#l1)
N20 IF #l1>100
N30 THEN
N40 #l2=#l1/2
N50 ENDIF
N60 #l2=#l1
N70 G0 X46 Z#l2
N80 M30
END
)nc"}},
    .good = {{"fanuc", R"nc(
O9214(ARC, S ANGLE)
#33=#19
IF[#19EQ#0]THEN#33=360.
G0 C#33
M99
)nc"},
             {"dinplus", R"nc(
MACHINING
N10 INPUT("Length",#l1)
N20 #l2=#l1
N30 IF #l1>100
N40 THEN
N50 #l2=#l1/2
N60 ENDIF
N70 G0 X46 Z#l2
N80 M30
END
)nc"}},
    .sources = {"SEED-002:366"},
    .check = &check,
};

namespace {

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    const Program& program = analysis.program();
    for (const queries::DeadStore& dead : queries::find_dead_stores(analysis)) {
        if (!dead.only_if || !dead.read_elsewhere) continue;
        const EffectId next = dead.replaced_by.front()->effect;
        const Span span = program.effects[dead.store->effect].span;
        const Span later = program.effects[next].span;
        Finding& finding =
            reporter.report({analysis, dead.store->effect}, span, "lost",
                            {quoted(program, span), quoted(program, program.expressions[*dead.only_if].span),
                             quoted(program, later), line_number(analysis.file(), later.begin),
                             with_letter(analysis, dead.store->variable)});
        finding.related.push_back(related_at_effect(analysis, next, "replaces the value in every case"));
        trace(finding, analysis, dead.store->node, "the special case sets the variable");
    }
}

} // namespace
} // namespace maclint::rules
