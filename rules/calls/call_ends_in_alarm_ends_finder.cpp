//! Walks from the start, or from a test, to the nearest alarm.
#include "rules/calls/call_ends_in_alarm_ends_finder.hpp"

#include "analyzer/flow/walk.hpp"
#include "analyzer/program/tables.hpp"
#include "analyzer/queries/calls/callers.hpp"
#include "analyzer/source/budget.hpp"

#include <algorithm>
#include <limits>
#include <utility>
#include <variant>
#include <vector>

namespace maclint::rules {
namespace {

constexpr flow::EdgeId none = std::numeric_limits<flow::EdgeId>::max();

/// The alarm in which a node ends, or the program that it calls and that does.
struct EndAt {
    std::optional<EffectId> stop;
    const ProgramAnalysis* called = nullptr;
};

EndAt end_at(const ProgramAnalysis& analysis, flow::NodeId node, const dataflow::Analysis& begun) {
    const Slice effects = analysis.graph().nodes[node].effects;
    const bool goes_on = std::ranges::any_of(analysis.graph().out[node],
                                             [&](flow::EdgeId edge) { return begun.passable(edge); });
    for (Id id = effects.first; id < effects.first + effects.count; ++id) {
        const auto& what = analysis.program().effects[id].what;
        const auto* stop = std::get_if<Stop>(&what);
        if (stop != nullptr && stop->kind == Stop::Kind::alarm) return {id};
        const CallSite* site = std::holds_alternative<Call>(what) ? analysis.call_at(id) : nullptr;
        const ProgramAnalysis* called = site == nullptr ? nullptr : queries::called_program(analysis, *site);
        const bool ends = !goes_on && called != nullptr && !site->in_cycle;
        if (ends && called->summary().alarm_end.always) return {std::nullopt, called};
    }
    return {};
}

/// Paths through a program, begun in one way, from one of its nodes.
class Nearest {
  public:
    Nearest(const ProgramAnalysis& analysis, const dataflow::Analysis& begun, flow::NodeId start)
        : graph_(analysis.graph())
        , begun_(begun)
        , came_by_(graph_.nodes.size(), none)
        , met_(graph_.nodes.size(), false)
        , nearest_{start} {
        met_[start] = true;
    }

    /// The nearest node of which `is_end` says so; nothing where there is none.
    template<class Ask>
    std::optional<flow::NodeId> find(const Ask& is_end) {
        for (std::size_t i = 0; i < nearest_.size(); ++i) {
            if (!Budget::allows()) break;
            const flow::NodeId node = nearest_[i];
            if (is_end(node)) return node;
            for (const flow::EdgeId edge : graph_.out[node])
                if (const flow::NodeId to = graph_.edges[edge].to; !met_[to] && begun_.passable(edge)) {
                    met_[to] = true;
                    came_by_[to] = edge;
                    nearest_.push_back(to);
                }
        }
        return std::nullopt;
    }

    [[nodiscard]] std::vector<flow::EdgeId> path_to(flow::NodeId node) const {
        std::vector<flow::EdgeId> path;
        while (came_by_[node] != none) {
            path.push_back(came_by_[node]);
            node = graph_.edges[path.back()].from;
        }
        std::ranges::reverse(path);
        return path;
    }

  private:
    const flow::Graph& graph_;
    const dataflow::Analysis& begun_;
    std::vector<flow::EdgeId> came_by_;
    std::vector<bool> met_;
    std::vector<flow::NodeId> nearest_;
};

/// Where the program can still come back, whatever it is called with.
std::vector<bool> nodes_that_return(const ProgramAnalysis& analysis) {
    std::vector<flow::NodeId> exits;
    std::vector<bool> returns(analysis.graph().nodes.size(), false);
    for (const flow::Exit& exit : analysis.graph().exits)
        if (exit.kind != flow::ExitKind::alarm && !returns[exit.node]) {
            returns[exit.node] = true;
            exits.push_back(exit.node);
        }
    flow::walk<flow::Direction::backward>(analysis.graph(), exits, [&](flow::EdgeId, flow::NodeId from) {
        returns[from] = true;
        return flow::Step::go_on;
    });
    return returns;
}

} // namespace

std::optional<AlarmReached> nearest_alarm(const ProgramAnalysis& analysis, const dataflow::Analysis& begun,
                                          flow::NodeId start, int levels) {
    Nearest search(analysis, begun, start);
    EndAt end;
    const auto node = search.find([&](flow::NodeId at) {
        end = end_at(analysis, at, begun);
        return end.stop || end.called != nullptr;
    });
    if (!node) return std::nullopt;
    if (!end.stop)
        return levels == 0 ? std::nullopt : nearest_alarm(*end.called, end.called->data(), 0, levels - 1);
    const Span text{analysis.program().effects[*end.stop].span.begin, analysis.graph().nodes[*node].part.end};
    Nearest others(analysis, begun, start);
    const bool several = others
                             .find([&](flow::NodeId at) {
                                 const EndAt other = end_at(analysis, at, begun);
                                 return at != *node && (other.stop || other.called != nullptr);
                             })
                             .has_value();
    return AlarmReached{&analysis, *end.stop, text, search.path_to(*node), several};
}

std::optional<flow::NodeId> last_test(const ProgramAnalysis& called, const dataflow::Analysis& begun) {
    const std::vector<bool> returns = nodes_that_return(called);
    const flow::Graph& graph = called.graph();
    return Nearest(called, begun, 0).find([&](flow::NodeId at) {
        return returns[at] && std::ranges::none_of(graph.out[at], [&](flow::EdgeId edge) {
                   return begun.passable(edge) && returns[graph.edges[edge].to];
               });
    });
}

std::vector<flow::EdgeId> path_to(const ProgramAnalysis& called, const dataflow::Analysis& begun,
                                  flow::NodeId node) {
    Nearest search(called, begun, 0);
    return search.find([&](flow::NodeId at) { return at == node; }) ? search.path_to(node)
                                                                    : std::vector<flow::EdgeId>();
}

} // namespace maclint::rules
