//! Reads depths off the workspace.
#include "analyzer/queries/calls/call_depth.hpp"

#include "analyzer/program/tables.hpp"
#include "analyzer/queries/calls/callers.hpp"

#include <algorithm>
#include <cstddef>
#include <variant>

namespace maclint::queries {

std::vector<CallSite> calls_beyond(const ProgramAnalysis& analysis, NestingLimit nesting, int limit) {
    std::vector<CallSite> calls;
    const int level = nesting == NestingLimit::macro ? analysis.depth().macro : analysis.depth().subprogram;
    if (level != limit) return calls;
    for (const CallSite& site : analysis.calls()) {
        const Call& call = call_of(analysis.program(), site.effect);
        if (site.closes_cycle || std::holds_alternative<std::monostate>(call.program)) continue;
        if (analysis.control().calls[call.kind].counts_against == nesting) calls.push_back(site);
    }
    return calls;
}

bool leads_to_level(const ProgramAnalysis& analysis, const CallSite& site, NestingLimit nesting, int level) {
    std::vector<const ProgramAnalysis*> reached;
    const auto reach = [&](const ProgramAnalysis& from, const CallSite& call) {
        const ProgramAnalysis* callee = called_program(from, call);
        if (callee != nullptr && std::ranges::find(reached, callee) == reached.end())
            reached.push_back(callee);
    };
    reach(analysis, site);
    std::size_t looked_at = 0; // `reached` grows
    while (looked_at < reached.size()) {
        const ProgramAnalysis& program = *reached[looked_at++];
        if (!calls_beyond(program, nesting, level).empty()) return true;
        for (const CallSite& call : program.calls())
            if (!call.closes_cycle) reach(program, call);
    }
    return false;
}

} // namespace maclint::queries
