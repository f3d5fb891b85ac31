//! Breadth first over the calls, one search for each program where paths begin.
#include "analyzer/workspace/call_paths.hpp"

#include "analyzer/workspace/program_analysis.hpp"

#include <algorithm>
#include <iterator>

namespace maclint {
namespace {

/// Searches that are kept.
constexpr std::size_t most_searches = 64;

/// A search goes to about so many programs: where thousands call each other in circles, each circle has its
/// own. How often they call each other does not count.
constexpr std::size_t most_reached = 1000;

constexpr std::size_t half = CallPath::most / 2;

} // namespace

CallPath CallPaths::between(ProgramIndex from, ProgramIndex to) {
    if (from == to) return {};
    const std::scoped_lock lock(mutex_);
    if (called_.size() == 0) gather_calls();
    if (searches_.size() > most_searches) searches_.clear();
    Search& search = searches_[from];
    const Step* step = reach(search, from, to);
    if (step == nullptr) return {};
    if (step->length <= CallPath::most) return {last_calls(search, to, step->length), step->length};
    CallPath path{last_calls(search, step->near, half), step->length};
    std::ranges::copy(last_calls(search, to, half), std::back_inserter(path.calls));
    return path;
}

void CallPaths::gather_calls() {
    for (const ProgramAnalysis& program : programs_) {
        for (const CallSite& site : program.calls()) {
            if (!site.target) continue;
            called_.add(*site.target);
            effects_.add(site.effect);
        }
        called_.end_list();
        effects_.end_list();
    }
}

const CallPaths::Step* CallPaths::reach(Search& search, ProgramIndex from, ProgramIndex to) {
    if (search.reached.empty()) search.pending = {from};
    auto found = search.reached.find(to);
    while (found == search.reached.end() && !search.pending.empty() && search.looked_at <= most_reached) {
        const ProgramIndex at = search.pending.front();
        search.pending.pop_front();
        const auto own = search.reached.find(at);
        const Step before = own == search.reached.end() ? Step{from, 0, 0, from} : own->second;
        const auto called = called_[at];
        for (std::size_t i = 0; i < called.size(); ++i) {
            if (called[i] == from) continue;
            const ProgramIndex near = before.length < half ? called[i] : before.near;
            const Step step{at, effects_[at][i], before.length + 1, near};
            if (!search.reached.try_emplace(called[i], step).second) continue;
            search.pending.push_back(called[i]);
            ++search.looked_at;
        }
        found = search.reached.find(to);
    }
    return found == search.reached.end() ? nullptr : &found->second;
}

std::vector<Caller> CallPaths::last_calls(const Search& search, ProgramIndex to, std::size_t count) {
    std::vector<Caller> calls;
    for (ProgramIndex at = to; calls.size() < count; at = calls.back().program) {
        const Step& step = search.reached.at(at);
        calls.push_back({step.caller, step.call});
    }
    std::ranges::reverse(calls);
    return calls;
}

} // namespace maclint
