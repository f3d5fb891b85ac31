//! Breadth first over the calls; one search goes on as long as paths from one program are asked for.
#include "analyzer/workspace/call_paths.hpp"

#include "analyzer/workspace/program_analysis.hpp"

#include <algorithm>
#include <iterator>

namespace maclint {
namespace {

/// A search goes to about so many programs: where thousands call each other in circles, each circle has its
/// own. How often they call each other does not count.
constexpr std::size_t most_reached = 1000;

constexpr std::size_t half = CallPath::most / 2;

} // namespace

CallPath CallPaths::between(ProgramIndex from, ProgramIndex to) {
    if (from == to) return {};
    const std::scoped_lock lock(mutex_);
    if (called_.size() == 0) gather_calls();
    if (from_ != from) begin(from);
    if (!reach(to)) return {};
    const std::size_t length = steps_[to].length;
    if (length <= CallPath::most) return {last_calls(to, length), length};
    CallPath path{last_calls(steps_[to].near, half), length};
    std::ranges::copy(last_calls(to, half), std::back_inserter(path.calls));
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

void CallPaths::begin(ProgramIndex from) {
    from_ = from;
    ++search_;
    reached_ = {from};
    next_ = 0;
    steps_.resize(called_.size());
    steps_[from] = {search_, from, 0, 0, from};
}

bool CallPaths::reach(ProgramIndex to) {
    while (steps_[to].search != search_ && next_ < reached_.size() && reached_.size() <= most_reached) {
        const ProgramIndex at = reached_[next_++];
        const Step before = steps_[at];
        const auto called = called_[at];
        for (std::size_t i = 0; i < called.size(); ++i) {
            Step& step = steps_[called[i]];
            if (step.search == search_) continue;
            const ProgramIndex near = before.length < half ? called[i] : before.near;
            step = {search_, at, effects_[at][i], before.length + 1, near};
            reached_.push_back(called[i]);
        }
    }
    return steps_[to].search == search_;
}

std::vector<Caller> CallPaths::last_calls(ProgramIndex to, std::size_t count) const {
    std::vector<Caller> calls;
    for (ProgramIndex at = to; calls.size() < count; at = calls.back().program)
        calls.push_back({steps_[at].caller, steps_[at].call});
    std::ranges::reverse(calls);
    return calls;
}

} // namespace maclint
