//! Reads depths and chains off the workspace.
#include "rules/calls/call_depth.hpp"

#include "analyzer/program/tables.hpp"
#include "analyzer/queries/calls/call_depth.hpp"
#include "analyzer/queries/calls/callers.hpp"
#include "rules/path.hpp"

namespace maclint::rules {

std::string name_of_callee(const ProgramAnalysis& analysis, const CallSite& site) {
    if (const ProgramAnalysis* callee = queries::called_program(analysis, site))
        return callee->program().name;
    const Program& program = analysis.program();
    const Call& call = queries::call_of(program, site.effect);
    if (const auto* text = std::get_if<Text>(&call.program)) return quoted(program, text->characters);
    const auto* number = std::get_if<ExpressionId>(&call.program);
    return number == nullptr ? std::string("?") : "P" + quoted(program, program.expressions[*number].span);
}

namespace {

/// "O1 > O9001 > O9002", from the outermost program over the analysed one to the callee.
std::string chain_words(const ProgramAnalysis& analysis, const CallSite& last, NestingLimit nesting) {
    std::string words;
    for (const Caller& caller : analysis.chain_to(nesting))
        words += queries::calling_program(analysis, caller).program().name + " > ";
    return words + analysis.program().name + " > " + name_of_callee(analysis, last);
}

/// The calls that lead to the program, outermost first, as steps of the finding's path.
void add_chain(Finding& finding, const ProgramAnalysis& analysis, NestingLimit nesting) {
    for (const Caller& caller : analysis.chain_to(nesting)) {
        const ProgramAnalysis& calling = queries::calling_program(analysis, caller);
        const std::string callee = name_of_callee(calling, *calling.call_at(caller.effect));
        finding.path.push_back(related_at_effect(calling, caller.effect, "calls " + callee));
    }
}

} // namespace

namespace {

int levels(const Limits& limits, NestingLimit nesting) {
    return nesting == NestingLimit::macro ? limits.macro_calls : limits.subprogram_calls;
}

Finding& report_call(const ProgramAnalysis& analysis, const CallSite& site, Reporter& reporter,
                     NestingLimit nesting, int limit, std::string_view message) {
    const Span span = analysis.program().effects[site.effect].span;
    Finding& finding = reporter.report({analysis, site.effect}, span, message,
                                       {quoted(analysis.program(), span), std::to_string(limit + 1),
                                        analysis.control().description, std::to_string(limit),
                                        chain_words(analysis, site, nesting)});
    add_chain(finding, analysis, nesting);
    finding.path.push_back(
        {analysis.source(), span, "calls " + name_of_callee(analysis, site) + ", one level too deep"});
    return finding;
}

} // namespace

void report_calls_beyond(const ProgramAnalysis& analysis, Reporter& reporter, NestingLimit nesting) {
    const ControlModel& control = analysis.control();
    const int limit = levels(control.limits, nesting);
    if (!control.limits_at_most) {
        for (const CallSite& site : queries::calls_beyond(analysis, nesting, limit))
            report_call(analysis, site, reporter, nesting, limit, "named");
        return;
    }
    const int most = levels(*control.limits_at_most, nesting);
    for (const CallSite& site : queries::calls_beyond(analysis, nesting, limit)) {
        if (queries::leads_to_level(analysis, site, nesting, most)) continue; // told there
        Finding& finding = report_call(analysis, site, reporter, nesting, limit, "assumed");
        finding.severity = Severity::warning;
        finding.alarm = {};
    }
    for (const CallSite& site : queries::calls_beyond(analysis, nesting, most))
        report_call(analysis, site, reporter, nesting, most, "most");
}

} // namespace maclint::rules
