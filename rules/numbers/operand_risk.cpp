//! Messages about operands that a program may be given.
#include "rules/numbers/operand_risk.hpp"

#include "analyzer/queries/callers.hpp"
#include "analyzer/queries/conditions.hpp"
#include "analyzer/queries/operand_risks.hpp"
#include "rules/path.hpp"
#include "rules/trace.hpp"

#include <algorithm>

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
    std::vector<std::string> arguments{quoted(program, span),
                                       quoted(program, program.expressions[operand].span),
                                       with_letter(analysis, risk.variable)};
    if (risk.other) arguments.push_back(with_letter(analysis, *risk.other));
    if (risk.check != nullptr)
        arguments.push_back(quoted(program, program.expressions[risk.check->expression].span));
    const ProgramAnalysis* calling = nullptr;
    if (risk.call != nullptr) {
        calling = &queries::calling_program(analysis, *risk.call);
        const Span call = calling->program().effects[risk.call->effect].span;
        arguments.push_back(line_number(calling->file(), call.begin));
        arguments.push_back(calling->program().name);
    }
    Finding& finding = reporter.report(Cause(analysis, application.effect, operand), span,
                                       message_of(risk.evidence), std::move(arguments));
    const bool is_warning = risk.evidence != Evidence::unchecked;
    finding.severity = std::min(finding.severity, is_warning ? Severity::warning : Severity::note);
    finding.alarm = {};
    if (calling != nullptr)
        finding.path.push_back(related_at_effect(*calling, risk.call->effect, "this call"));
    if (risk.check != nullptr)
        finding.related.push_back(
            {analysis.source(), program.expressions[risk.check->expression].span, "0 passes this check"});
    trace(finding, analysis, application.node, "it is calculated here");
}

} // namespace

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
