//! Reads depths and chains off the workspace.
#include "rules/calls/call_depth.hpp"

#include "rules/path.hpp"

namespace maclint::rules {

std::vector<CallSite> calls_beyond(const ProgramAnalysis& analysis, Counted counted, int limit) {
    std::vector<CallSite> calls;
    const int level = counted == Counted::macro ? analysis.depth().macro : analysis.depth().subprogram;
    if (level != limit) return calls;
    for (const CallSite& site : analysis.calls()) {
        if (!site.target || site.closes_cycle) continue;
        const auto& call = std::get<Call>(analysis.program().effects[site.effect].what);
        if (analysis.control().calls[call.kind].counted == counted) calls.push_back(site);
    }
    return calls;
}

std::string chain_words(const ProgramAnalysis& analysis, const ProgramAnalysis& callee, Counted counted) {
    std::string words;
    for (const Caller& caller : analysis.chain_to(counted))
        words += analysis.workspace().programs()[caller.program].program().name + " > ";
    return words + analysis.program().name + " > " + callee.program().name;
}

void add_chain(Finding& finding, const ProgramAnalysis& analysis, Counted counted) {
    for (const Caller& caller : analysis.chain_to(counted)) {
        const ProgramAnalysis& calling = analysis.workspace().programs()[caller.program];
        const CallSite* site = calling.call_at(caller.effect);
        const std::string& callee = analysis.workspace().programs()[*site->target].program().name;
        finding.path.push_back(remark_at_effect(calling, caller.effect, "calls " + callee));
    }
}

} // namespace maclint::rules
