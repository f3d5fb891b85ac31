//! MAC333: a return to a block that the caller lacks.
#include "analyzer/dataflow/facts/exit_state.hpp"
#include "analyzer/program/tables.hpp"
#include "analyzer/queries/calls/callers.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"
#include "rules/trace.hpp"

#include <vector>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule m99_p_missing_label{
    .code = "MAC333",
    .name = "m99-p-missing-label",
    .summary = "A program returns to a sequence number that its caller does not have",
    .why = "The control returns to the caller, searches the sequence number there and stops with"
           " an alarm.",
    .severity = Severity::error,
    .precision = Precision::very_high,
    .needs = {Capability::jumps},
    .facts = dataflow::facts<dataflow::ExitState>(),
    .data_flow = true,
    .stands_without_path = true,
    .messages =
        {{"plain", "Missing return block: '{0}' returns to N{1}, which the caller {2} does not have.",
          "Add the sequence number there, or return without P."},
         {"within",
          "Return block of the caller: '{0}' returns to N{1}, which the caller {2} does not have; here "
          "it stands in the program itself.",
          "If the program runs on {3}, which would jump there, name that (--control)."},
         {"uncalled",
          "Missing sequence number: nobody calls this program, so '{0}' goes on at its own N{1}, "
          "which it does not have.",
          "Add the sequence number, or correct it."}},
    .bad = {{"fanuc", R"nc(
O0001(MAIN)
M98P9333
N50 M30
O9333(CHECK)
IF[#100EQ1]GOTO1
M99P500
N1 M99
)nc"}},
    .good = {{"fanuc", R"nc(
O0001(MAIN)
M98P9333
N50 M30
O9333(CHECK)
IF[#100EQ1]GOTO1
M99P50
N1 M99
)nc"}},
    .alarms = {{"FANUC 30i/0i-D", "078", "SEQUENCE NUMBER NOT FOUND"},
               {"FANUC 16i/18i/21i", "078", "NUMBER NOT FOUND"}},
    .sources = {"INTELITEK-M99", "GH-ALM"},
    .check = &check,
};

namespace {

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    if (analysis.is_recursive()) return;
    const Program& program = analysis.program();
    const std::vector<const Caller*> callers = queries::first_callers(analysis);
    for (const dataflow::ExitState& exit : analysis.facts().all<dataflow::ExitState>()) {
        if (exit.exit.kind != flow::ExitKind::returns || !exit.exit.effect) continue;
        const Effect& effect = program.effects[*exit.exit.effect];
        const auto& label = std::get<Return>(effect.what).resume_label;
        const auto number = label ? flow::constant_number(program, *label) : std::nullopt;
        if (!number) continue;
        if (queries::is_called_by_nobody(analysis) && !analysis.graph().has_label(*number)) {
            Finding& finding = reporter.report(
                {analysis, *exit.exit.effect}, effect.span, "uncalled",
                {quoted(program, effect.span), quoted(program, program.expressions[*label].span)});
            trace(finding, analysis, exit.exit.node, "there is no such sequence number");
        }
        const Caller* caller = queries::find_caller_lacking(analysis, callers, *number);
        if (caller == nullptr) continue;
        const ProgramAnalysis& calling = queries::calling_program(analysis, *caller);
        const std::string& elsewhere = analysis.control().returns_within;
        const bool within = !elsewhere.empty() && analysis.graph().has_label(*number);
        Finding& finding =
            reporter.report({analysis, *exit.exit.effect}, effect.span, within ? "within" : "plain",
                            {quoted(program, effect.span), quoted(program, program.expressions[*label].span),
                             calling.program().name, elsewhere});
        if (within) {
            finding.severity = Severity::warning;
            finding.alarm = {};
        }
        finding.path.push_back(related_at_effect(calling, caller->effect, "calls " + program.name));
        trace(finding, analysis, exit.exit.node, "returns to a sequence number that the caller lacks");
    }
}

} // namespace
} // namespace maclint::rules
