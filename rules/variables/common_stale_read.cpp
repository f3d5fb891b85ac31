//! MAC216: a common variable is read that keeps what an earlier run has left in it.
#include "analyzer/dataflow/facts/clobber.hpp"
#include "analyzer/dataflow/facts/comparison.hpp"
#include "analyzer/dataflow/facts/read.hpp"
#include "analyzer/dataflow/facts/store.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"
#include "rules/trace.hpp"
#include "rules/variables/common_stale_read_cases_finder.hpp"
#include "rules/variables/common_stale_read_checks_finder.hpp"

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule common_stale_read{
    .code = "MAC216",
    .name = "common-stale-read",
    .summary =
        "A common variable is set for some numbers of a decision, and read for another that the program "
        "asks for as well, or checked before the program sets it",
    .why = "The variable still holds what the run before has left there, or is vacant after the control was "
           "switched on: the program runs with the number of another part.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .facts = dataflow::facts<dataflow::Read, dataflow::Comparison, dataflow::Store, dataflow::Clobber>(),
    .data_flow = true,
    .messages = {{"case",
                  "Value from the run before: {0} is set for {1} only, and read here for {2}, which "
                  "line {3} asks for.",
                  "Set it in that case, too, or refuse the case with an alarm."},
                 {"limit",
                  "Value from the run before: '{0}' looks at {1}, which the program sets on line {2} only.",
                  "Move the check behind that line, or correct the variable."}},
    .bad = {{"fanuc", R"nc(
O9216(PASSES)
IF[#4012EQ54]GOTO1
IF[#4012EQ55]GOTO1
IF[#4012EQ56]GOTO1
#3000=1(WORK OFFSET)
N1
IF[#4012EQ54]THEN#103=3
IF[#4012EQ56]THEN#103=2
G0 X#103
M99
)nc"},
            {"fanuc", R"nc(
O9217(POCKET, Z DEPTH R CLEARANCE W START)
IF[#26LE0]GOTO9
IF[#106+#23GT80.]GOTO9
#106=#26-#18
G0 Z-#106
G0 Z#23
M99
N9 #3000=1(Z OR TOOL LENGTH)
)nc"}},
    .good = {{"fanuc", R"nc(
O9216(PASSES)
IF[#4012EQ54]GOTO1
IF[#4012EQ56]GOTO1
#3000=1(WORK OFFSET)
N1
IF[#4012EQ54]THEN#103=3
IF[#4012EQ56]THEN#103=2
G0 X#103
M99
)nc"},
             {"fanuc", R"nc(
O9217(POCKET, Z DEPTH R CLEARANCE W START)
IF[#26LE0]GOTO9
#106=#26-#18
IF[#106+#23GT80.]GOTO9
G0 Z-#106
G0 Z#23
M99
N9 #3000=1(Z OR TOOL LENGTH)
)nc"}},
    .exemptions = {{&exemptions::held_against_last_value,
                    "held-against-the-last-value",
                    "The limit looks at what the new value is calculated from, too: it holds this run "
                    "against the last one.",
                    {"fanuc", R"nc(
O9216(GAP, X)
IF[ABS[#100-#24]GT1.]GOTO9
#100=#24*2
G90 G0 X#100
M99
N9 #3000=1(MOVED)
)nc"}}},
    .sources = {"SEED-002:357"},
    .check = &check,
};

namespace {

/// "#4012 = 54, 56"
std::string words_for(const ProgramAnalysis& analysis, const StaleRead& stale) {
    const Program& program = analysis.program();
    std::string words;
    for (const ExpressionId number : stale.set_for)
        words += (words.empty() ? quoted(program, program.expressions[stale.subject].span) + " = " : ", ") +
                 quoted(program, program.expressions[number].span);
    return words;
}

void report_limits(const ProgramAnalysis& analysis, Reporter& reporter) {
    const Program& program = analysis.program();
    for (const EarlyCheck& early : find_early_checks(analysis)) {
        const Span span = program.expressions[early.read->expression].span;
        Finding& finding = reporter.report(
            {analysis, *early.read}, span, "limit",
            {quoted(program, program.effects[early.read->effect].span), program.spell(early.read->variable),
             line_number(analysis.file(), program.effects[early.store->effect].span.begin)});
        finding.related.push_back(related_at_effect(analysis, early.store->effect, "it is set here"));
        trace(finding, analysis, early.read->node, "it is checked as the run before has left it");
    }
}

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    report_limits(analysis, reporter);
    const Program& program = analysis.program();
    for (const StaleRead& stale : find_stale_reads(analysis)) {
        const Span span = program.expressions[stale.read->expression].span;
        const Span asked = program.expressions[stale.missing].span;
        Finding& finding =
            reporter.report({analysis, *stale.read}, span, "case",
                            {program.spell(stale.read->variable), words_for(analysis, stale),
                             quoted(program, asked), line_number(analysis.file(), asked.begin)});
        for (RelatedLocation& step : steps_along(analysis, stale.path))
            finding.path.push_back(std::move(step));
        finding.path.push_back({analysis.source(), span, "it is read as the run before has left it"});
    }
}

} // namespace
} // namespace maclint::rules
