//! Breadth first over the calls; one search goes on as long as paths from one program are asked for.
#include "analyzer/workspace/call_paths.hpp"

#include "analyzer/workspace/program_analysis.hpp"

#include <algorithm>

namespace maclint {
namespace {

/// A search goes to about so many programs: where thousands call each other in circles, each circle has its
/// own. How often they call each other does not count.
constexpr std::size_t most_reached = 256;

constexpr std::size_t half = CallPath::most / 2;

} // namespace

CallPaths::CallPaths(const std::deque<ProgramAnalysis>& programs)
    : programs_(programs) {}

CallPath CallPaths::between(ProgramIndex from, ProgramIndex to) {
    if (from == to) return {};
    const std::scoped_lock lock(mutex_);
    if (called_.size() == 0) gather_calls();
    if (from_ != from) begin(from);
    if (!reach(to)) return {};
    CallPath path{calls_to(marks_[to].step), 0};
    path.length = path.calls.size();
    if (path.length > CallPath::most) path.calls.erase(path.calls.begin() + half, path.calls.end() - half);
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
    steps_ = {{from, 0, 0}};
    next_ = 0;
    marks_.resize(called_.size());
    marks_[from] = {search_, 0};
}

bool CallPaths::reach(ProgramIndex to) {
    while (marks_[to].search != search_ && next_ < steps_.size() && steps_.size() <= most_reached) {
        const auto before = static_cast<std::uint32_t>(next_++);
        const auto called = called_[steps_[before].program];
        for (std::uint32_t call = 0; call < called.size(); ++call) {
            Mark& mark = marks_[called[call]];
            if (mark.search == search_) continue;
            mark = {search_, static_cast<std::uint32_t>(steps_.size())};
            steps_.push_back({called[call], before, call});
        }
    }
    return marks_[to].search == search_;
}

std::vector<Caller> CallPaths::calls_to(std::uint32_t step) const {
    std::vector<Caller> calls;
    for (; step != 0; step = steps_[step].before) {
        const ProgramIndex caller = steps_[steps_[step].before].program;
        calls.push_back({caller, effects_[caller][steps_[step].call]});
    }
    std::ranges::reverse(calls);
    return calls;
}

} // namespace maclint
