//! MAC214: what a special case sets is set again before anything reads it.
#include "analyzer/dataflow/facts/clobber.hpp"
#include "analyzer/dataflow/facts/read.hpp"
#include "analyzer/dataflow/facts/store.hpp"
#include "analyzer/queries/values/dead_stores.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"
#include "rules/trace.hpp"
#include "rules/variables/overwritten_conditional_finder.hpp"

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
    .facts = dataflow::facts<dataflow::Store, dataflow::Read, dataflow::Clobber>(),
    .data_flow = true,
    .messages = {{"lost",
                  "Special case lost: '{0}', which depends on '{1}', is replaced by '{2}' on line {3} "
                  "before anything reads {4}.",
                  "Put the special case after line {3}, or jump over that line."},
                 {"covered",
                  "Special case lost: '{0}', which depends on '{1}', is replaced by '{2}' on line {3} "
                  "before anything reads {4}: '{5}' is true then as well.",
                  "Put the special case after line {3}, or narrow the condition there."}},
    .bad = {{"fanuc", R"nc(
O9214(ARC, S ANGLE)
IF[#19EQ0]THEN#33=360.
#33=#19
G0 C#33
M99
)nc"},
            {"fanuc", R"nc(
O9215(PARK BEHIND THE OFFSET IN FORCE)
IF[#4012GT57]THEN#100=#413
IF[#4012GT55]THEN#100=#414
G90 G0 Z#100
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
             {"fanuc", R"nc(
O9215(PARK BEHIND THE OFFSET IN FORCE)
#100=#412
IF[#4012GT55]THEN#100=#414
IF[#4012GT57]THEN#100=#413
G90 G0 Z#100
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

/// A case and what replaces it, which the condition decides.
void report(const ProgramAnalysis& analysis, Reporter& reporter, const dataflow::Store& store,
            ExpressionId condition, EffectId next, std::optional<ExpressionId> covered_by) {
    const Program& program = analysis.program();
    const Span span = program.effects[store.effect].span;
    const Span later = program.effects[next].span;
    std::vector<std::string> words{
        quoted(program, span), quoted(program, program.expressions[condition].span), quoted(program, later),
        line_number(analysis.file(), later.begin), with_letter(analysis, store.variable)};
    if (covered_by) words.push_back(quoted(program, program.expressions[*covered_by].span));
    Finding& finding =
        reporter.report({analysis, store.effect}, span, covered_by ? "covered" : "lost", std::move(words));
    finding.related.push_back(related_at_effect(analysis, next, "replaces the value in every case"));
    trace(finding, analysis, store.node, "the special case sets the variable");
}

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    for (const queries::DeadStore& dead : queries::find_dead_stores(analysis))
        if (dead.only_if && dead.read_elsewhere)
            report(analysis, reporter, *dead.store, *dead.only_if, dead.replaced_by.front()->effect, {});
    for (const CoveredCase& covered : find_covered_cases(analysis))
        report(analysis, reporter, *covered.store, covered.condition, covered.replaced_by->effect,
               covered.later_condition);
}

} // namespace
} // namespace maclint::rules
