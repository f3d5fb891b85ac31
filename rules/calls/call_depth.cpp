//! Reads depths and chains off the workspace.
#include "rules/calls/call_depth.hpp"

#include "rules/path.hpp"

namespace maclint::rules {

namespace {

/// The calls of the program that reach the first level beyond the limit. Deeper ones have the same cause.
std::vector<CallSite> calls_beyond(const ProgramAnalysis& analysis, NestingLimit nesting, int limit) {
    std::vector<CallSite> calls;
    const int level = nesting == NestingLimit::macro ? analysis.depth().macro : analysis.depth().subprogram;
    if (level != limit) return calls;
    for (const CallSite& site : analysis.calls()) {
        const auto& call = std::get<Call>(analysis.program().effects[site.effect].what);
        if (site.closes_cycle || std::holds_alternative<std::monostate>(call.program)) continue;
        if (analysis.control().calls[call.kind].counts_against == nesting) calls.push_back(site);
    }
    return calls;
}

} // namespace

std::string name_of_callee(const ProgramAnalysis& analysis, const CallSite& site) {
    if (site.target) return analysis.workspace().programs()[*site.target].program().name;
    const Program& program = analysis.program();
    const auto& call = std::get<Call>(program.effects[site.effect].what);
    if (const auto* text = std::get_if<Text>(&call.program)) return quoted(program, text->characters);
    const auto* number = std::get_if<ExpressionId>(&call.program);
    return number == nullptr ? std::string("?") : "P" + quoted(program, program.expressions[*number].span);
}

namespace {

/// "O1 > O9001 > O9002", from the outermost program over the analysed one to the callee.
std::string chain_words(const ProgramAnalysis& analysis, const CallSite& last, NestingLimit nesting) {
    std::string words;
    for (const Caller& caller : analysis.chain_to(nesting))
        words += analysis.workspace().programs()[caller.program].program().name + " > ";
    return words + analysis.program().name + " > " + name_of_callee(analysis, last);
}

/// The calls that lead to the program, outermost first, as steps of the finding's path.
void add_chain(Finding& finding, const ProgramAnalysis& analysis, NestingLimit nesting) {
    for (const Caller& caller : analysis.chain_to(nesting)) {
        const ProgramAnalysis& calling = analysis.workspace().programs()[caller.program];
        const CallSite* site = calling.call_at(caller.effect);
        const std::string& callee = analysis.workspace().programs()[*site->target].program().name;
        finding.path.push_back(related_at_effect(calling, caller.effect, "calls " + callee));
    }
}

} // namespace

void report_calls_beyond(const ProgramAnalysis& analysis, Reporter& reporter, NestingLimit nesting,
                         int limit) {
    const ControlModel& control = analysis.control();
    for (const CallSite& site : calls_beyond(analysis, nesting, limit)) {
        const Span span = analysis.program().effects[site.effect].span;
        Finding& finding =
            reporter.report({analysis, site.effect}, span, control.assumed ? "assumed" : "named",
                            {quoted(analysis.program(), span), std::to_string(limit + 1), control.description,
                             std::to_string(limit), chain_words(analysis, site, nesting)});
        add_chain(finding, analysis, nesting);
        finding.path.push_back(
            {analysis.source(), span, "calls " + name_of_callee(analysis, site) + ", one level too deep"});
    }
}

} // namespace maclint::rules
