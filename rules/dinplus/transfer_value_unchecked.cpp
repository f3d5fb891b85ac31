//! DIN330: a transfer value that some caller leaves out is used without asking.
#include "analyzer/dataflow/facts/comparison.hpp"
#include "analyzer/dataflow/facts/read.hpp"
#include "analyzer/program/tables.hpp"
#include "analyzer/queries/calls/callers.hpp"
#include "analyzer/queries/calls/provoking_calls.hpp"
#include "analyzer/queries/conditions/conditions.hpp"
#include "analyzer/queries/paths/feasible_paths.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"
#include "rules/trace.hpp"

#include <algorithm>
#include <string>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule transfer_value_unchecked{
    .code = "DIN330",
    .name = "transfer-value-unchecked",
    .summary = "A transfer value that some caller leaves out is used without DEF or NDEF, or tested against "
               "0 instead",
    .why = "A value left out is undefined: it may read as 0, and a caller may pass 0 on purpose. Only DEF "
           "and NDEF tell the two apart.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .needs = {Capability::named_arguments, Capability::undefined_variables},
    .facts = dataflow::facts<dataflow::Read, dataflow::Comparison>(),
    .data_flow = true,
    .messages = {{"unchecked",
                  "Transfer value left out: {0} is used here, but the call on {1} does not pass it.",
                  "Ask with DEF or NDEF first, or pass it."},
                 {"zero-test",
                  "Transfer value tested for 0: '{2}' does not tell a value left out, as by the call on {1}, "
                  "from a 0 that is passed.",
                  "Ask with NDEF."}},
    .bad = {{"dinplus", R"nc(
MACHINING
N10 L"CHAMFER" LA50
N12 M30
SUBPROGRAM "CHAMFER"
N20 G0 X#__la Z2
N21 G1 Zi-#__lc
RETURN
END
)nc"},
            {"dinplus", R"nc(
MACHINING
N10 L"CHAMFER" LA50
N12 M30
SUBPROGRAM "CHAMFER"
N20 G0 X#__la Z2
N21 IF #__lc==0
N22 THEN
N23 G1 Zi-1
N24 ENDIF
RETURN
END
)nc"}},
    .good = {{"dinplus", R"nc(
MACHINING
N10 L"CHAMFER" LA50
N12 M30
SUBPROGRAM "CHAMFER"
N20 G0 X#__la Z2
N21 IF DEF(__lc)
N22 THEN
N23 G1 Zi-#__lc
N24 ENDIF
RETURN
END
)nc"}},
    .sources = {"SEED-003:19721", "SEED-003:19732", "SEED-003:19742"},
    .check = &check,
};

namespace {

/// A value that nothing has asked for on the path here, or beside it in its condition: it is unknown whether
/// IF NDEF(__ld) OR (#__ld==0) still looks at what decides nothing any more. Languages that tell vacant from
/// 0 in every comparison have rules of their own.
bool is_unchecked(const ProgramAnalysis& analysis, const dataflow::Read& read) {
    const auto& formals = analysis.control().formals;
    return analysis.control().spaces[read.variable.space].initial_value == InitialValue::undefined &&
           read.use != dataflow::Use::vacancy_test && read.value.vacancy == dataflow::Vacancy::maybe &&
           std::ranges::find(formals, read.variable) != formals.end() &&
           !queries::asks_for_vacancy(analysis.program(), analysis.facts(), read.node, read.node,
                                      read.variable);
}

void report(const ProgramAnalysis& analysis, const dataflow::Read& read, const Caller& caller,
            Reporter& reporter) {
    const Program& program = analysis.program();
    const ProgramAnalysis& calling = queries::calling_program(analysis, caller);
    const Span call = calling.program().effects[caller.effect].span;
    const dataflow::Comparison* test = queries::zero_test_of(analysis, read);
    const Span span = program.expressions[test != nullptr ? test->expression : read.expression].span;
    std::string variable = "line " + line_number(calling.file(), call.begin);
    if (&calling.file() != &analysis.file()) variable += " of " + calling.program().name;
    Finding& finding = reporter.report(test != nullptr ? Cause{analysis, *test} : Cause{analysis, read}, span,
                                       test != nullptr ? "zero-test" : "unchecked",
                                       {program.spell(read.variable), variable, quoted(program, span)});
    finding.path.push_back(related_at_effect(calling, caller.effect,
                                             "this call leaves " + program.spell(read.variable) + " out"));
    trace(finding, analysis, read.node, "and nothing has asked for it before it is used");
}

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    // What an IF without its ENDIF guards is unknown.
    if (analysis.regions().balance_unknown || !analysis.regions().faults.empty()) return;
    std::vector<Variable> reported;
    for (const dataflow::Read& read : analysis.facts().all<dataflow::Read>()) {
        if (!is_unchecked(analysis, read) || std::ranges::find(reported, read.variable) != reported.end())
            continue;
        const auto changing = queries::nodes_that_may_change(analysis, read.variable, read.node);
        const Caller* caller = queries::find_caller_without(analysis, read.variable, [&](const Caller& each) {
            return bool{queries::nodes_reached_by(analysis, each, changing)[read.node]};
        });
        if (caller == nullptr) continue;
        reported.push_back(read.variable);
        report(analysis, read, *caller, reporter);
    }
}

} // namespace
} // namespace maclint::rules
