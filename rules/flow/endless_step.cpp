//! Chooses the message for a step that does not end its loop.
#include "rules/flow/endless_step.hpp"

#include "analyzer/queries/calls/callers.hpp"
#include "analyzer/queries/values/origins.hpp"
#include "analyzer/queries/values/passed_values.hpp"
#include "rules/path.hpp"
#include "rules/trace.hpp"

#include <optional>
#include <string>

namespace maclint::rules {
namespace {

using queries::StepFault;

std::string name_of_vacancy_origin(const ProgramAnalysis& analysis, const dataflow::Step& step) {
    const auto variable = queries::variable_of_origin(analysis, step.amount.vacancy_origin);
    if (variable) return analysis.program().spell(*variable);
    return "'" + quoted(analysis.program(), analysis.program().expressions[step.expression].span) + "'";
}

/// The step with the call that passes its amount.
Finding& report_call(const ProgramAnalysis& analysis, Reporter& reporter, const dataflow::Store& store,
                     const queries::PassedValue& passed) {
    const Program& program = analysis.program();
    const Span span = program.effects[store.effect].span;
    const ProgramAnalysis& calling = queries::calling_program(analysis, *passed.call);
    const Span call = calling.program().effects[passed.call->effect].span;
    Finding& finding = reporter.report(
        {analysis, store.effect}, span, passed.number == 0 ? "passed-zero" : "passed-sign",
        {quoted(program, span), line_number(calling.file(), call.begin), calling.program().name});
    finding.path.push_back(related_at_effect(calling, passed.call->effect, "this call"));
    trace(finding, analysis, store.node, "the counter is changed here");
    return finding;
}

std::optional<queries::PassedValue> passed_for(const ProgramAnalysis& analysis,
                                               const queries::Counter& counter, StepFault fault) {
    const dataflow::Step& step = *counter.steps.front()->step;
    if (fault == StepFault::wrong_sign_passed) return queries::call_that_leads_away(analysis, counter, step);
    if (fault != StepFault::vacant) return std::nullopt;
    return queries::value_for_a_call(analysis, step.amount, [](const queries::PassedValue& value) {
        return value.number == 0 && !value.left_out;
    });
}

} // namespace

Finding& report_step(const ProgramAnalysis& analysis, Reporter& reporter, const queries::Counter& counter,
                     StepFault fault) {
    const Program& program = analysis.program();
    const dataflow::Store& store = *counter.steps.front();
    const Span span = program.effects[store.effect].span;
    const std::string text = quoted(program, span);
    if (const auto passed = passed_for(analysis, counter, fault))
        return report_call(analysis, reporter, store, *passed);
    if (fault == StepFault::vacant) {
        const std::string name = name_of_vacancy_origin(analysis, *store.step);
        Finding& finding = reporter.report({analysis, store.effect}, span, "vacant", {text, name});
        if (queries::is_never_passed_as_zero(analysis, store.step->amount)) finding.severity = Severity::note;
        trace_vacancy(finding, analysis, store.step->amount.vacancy_origin, name, store.node,
                      "a vacant " + name + " counts as 0 in arithmetic");
        return finding;
    }
    Finding& finding = reporter.report({analysis, store.effect}, span,
                                       fault == StepFault::zero ? "zero" : "wrong-sign", {text});
    trace(finding, analysis, store.node, "the counter is changed here");
    return finding;
}

} // namespace maclint::rules
