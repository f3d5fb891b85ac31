//! Messages about values that a program may be given.
#include "rules/operand_risk.hpp"

#include "analyzer/queries/calls/callers.hpp"
#include "analyzer/queries/conditions/conditions.hpp"
#include "rules/path.hpp"
#include "rules/trace.hpp"

#include <algorithm>
#include <optional>
#include <string_view>
#include <utility>

namespace maclint::rules {
namespace {

using Evidence = queries::OperandRisk::Evidence;

std::string_view message_of(Evidence evidence) {
    switch (evidence) {
    case Evidence::passed: return "passed";
    case Evidence::left_out: return "left-out";
    case Evidence::lets_zero_pass: return "lets-zero-pass";
    case Evidence::asked_vacancy: return "asked-vacancy";
    case Evidence::others_checked: return "others-checked";
    default: return "unchecked";
    }
}

void report(const ProgramAnalysis& analysis, const dataflow::Application& application,
            const queries::OperandRisk& risk, Reporter& reporter) {
    const Program& program = analysis.program();
    const ExpressionId operand = application.right_expression;
    const Span span = program.expressions[application.expression].span;
    Finding& finding = report_risk(analysis, risk, Cause(analysis, application.effect, operand), span,
                                   {quoted(program, span), quoted(program, program.expressions[operand].span),
                                    with_letter(analysis, risk.variable)},
                                   reporter);
    trace(finding, analysis, application.node, "it is calculated here");
}

} // namespace

Finding& report_risk(const ProgramAnalysis& analysis, const queries::OperandRisk& risk, const Cause& cause,
                     Span span, std::vector<std::string> words, Reporter& reporter) {
    const Program& program = analysis.program();
    std::optional<Span> check;
    if (risk.check != nullptr) check = program.expressions[risk.check->expression].span;
    if (risk.other) words.push_back(with_letter(analysis, *risk.other));
    if (check) words.push_back(quoted(program, *check));
    const ProgramAnalysis* calling = nullptr;
    if (risk.call != nullptr) {
        calling = &queries::calling_program(analysis, *risk.call);
        const Span call = calling->program().effects[risk.call->effect].span;
        words.push_back(line_number(calling->file(), call.begin));
        words.push_back(calling->program().name);
    }
    Finding& finding = reporter.report(cause, span, message_of(risk.evidence), std::move(words));
    const bool is_shown = risk.evidence != Evidence::unchecked;
    finding.severity = std::min(finding.severity, is_shown ? Severity::warning : Severity::note);
    finding.alarm = {};
    if (calling != nullptr)
        finding.path.push_back(related_at_effect(*calling, risk.call->effect, "this call"));
    if (check) finding.related.push_back({analysis.source(), *check, "0 passes this check"});
    return finding;
}

void report_risks(const ProgramAnalysis& analysis, Operation operation, Reporter& reporter) {
    std::optional<queries::OperandRisks> risks;
    std::vector<Variable> reported;
    for (const dataflow::Application& application : analysis.facts().all<dataflow::Application>()) {
        if (application.operation != operation || application.right.low == application.right.high ||
            queries::may_be_left_out(analysis.program(), analysis.facts(), application.effect,
                                     application.expression))
            continue;
        if (!risks) risks.emplace(analysis);
        const auto risk = risks->risk_of(application);
        if (!risk || std::ranges::find(reported, risk->variable) != reported.end()) continue;
        reported.push_back(risk->variable);
        report(analysis, application, *risk, reporter);
    }
}

} // namespace maclint::rules
