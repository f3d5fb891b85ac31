//! Reads depths off the workspace.
#include "analyzer/queries/call_depth.hpp"

#include "analyzer/program/tables.hpp"
#include "analyzer/queries/callers.hpp"

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

} // namespace maclint::queries
