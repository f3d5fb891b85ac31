//! Looks at what is reached: exits, work, and how the blocks before an alarm are reached.
#include "analyzer/dataflow/solver/alarm_end.hpp"

#include "analyzer/program/block_view.hpp"

#include <algorithm>
#include <optional>
#include <variant>

namespace maclint::dataflow {
namespace {

bool is_alarm(const Effect& effect) {
    const auto* stop = std::get_if<Stop>(&effect.what);
    return stop != nullptr && stop->kind == Stop::Kind::alarm;
}

/// Whether jumps lead there, whatever variables hold.
bool is_in_text(const flow::Graph& graph, flow::NodeId node) {
    return graph.order[node] != flow::Graph::no_order;
}

class Finder {
  public:
    Finder(const Program& program, const flow::Graph& graph, const Callees& callees,
           const std::vector<bool>& reached)
        : program_(program)
        , graph_(graph)
        , callees_(callees)
        , reached_(reached) {}

    AlarmEnd run(bool returns) const {
        const auto in_text = [this](flow::NodeId node) { return is_in_text(graph_, node); };
        const auto reached = [this](flow::NodeId node) -> bool { return reached_[node]; };
        AlarmEnd end;
        end.possible = std::ranges::any_of(graph_.with_effects,
                                           [&](flow::NodeId node) { return reached(node) && alarms(node); });
        end.works = any_node(in_text, [this](flow::NodeId node) { return works(node); });
        if (!end.possible) return end;
        end.always = !returns && has_only_alarms(reached);
        end.in_text = end.always && has_only_alarms(in_text);
        end.by_mistake =
            end.in_text && end.works && std::ranges::any_of(graph_.exits, [this](const flow::Exit& exit) {
                return exit.kind == flow::ExitKind::alarm && is_in_text(graph_, exit.node) &&
                       is_fallen_into(graph_, exit);
            });
        return end;
    }

  private:
    template<class Among, class Predicate>
    [[nodiscard]] bool any_node(const Among& among, const Predicate& predicate) const {
        for (flow::NodeId node = 0; node < graph_.nodes.size(); ++node)
            if (among(node) && predicate(node)) return true;
        return false;
    }

    template<class Among>
    [[nodiscard]] bool has_only_alarms(const Among& among) const {
        return std::ranges::all_of(graph_.exits, [&](const flow::Exit& exit) {
            return exit.kind == flow::ExitKind::alarm || !among(exit.node);
        });
    }

    [[nodiscard]] const AlarmEnd* end_of_call(Id effect) const {
        const bool is_call = std::holds_alternative<Call>(program_.effects[effect].what);
        return is_call ? &callees_(effect).summary.alarm_end : nullptr;
    }

    [[nodiscard]] bool alarms(flow::NodeId node) const {
        const Slice effects = graph_.nodes[node].effects;
        for (Id id = effects.first; id < effects.first + effects.count; ++id) {
            const AlarmEnd* called = end_of_call(id);
            if (is_alarm(program_.effects[id]) || (called != nullptr && called->always)) return true;
        }
        return false;
    }

    [[nodiscard]] bool works(flow::NodeId node) const {
        const Slice effects = graph_.nodes[node].effects;
        if (graph_.nodes[node].is_run) return moves(program_, graph_.nodes[node].stretch());
        for (Id id = effects.first; id < effects.first + effects.count; ++id) {
            const auto& what = program_.effects[id].what;
            const AlarmEnd* called = end_of_call(id);
            if (std::holds_alternative<Motion>(what) || std::holds_alternative<ToolChange>(what) ||
                (called != nullptr && called->works))
                return true;
        }
        return false;
    }

    const Program& program_;
    const flow::Graph& graph_;
    const Callees& callees_;
    const std::vector<bool>& reached_;
};

} // namespace

bool is_fallen_into(const flow::Graph& graph, const flow::Exit& alarm) {
    constexpr int most_nodes = 16; // from the sequence number to its alarm
    flow::NodeId node = alarm.node;
    for (int i = 0; i < most_nodes; ++i) {
        const auto edges = graph.in[node];
        const auto comes_by = [&](flow::EdgeKind kind) {
            return std::ranges::any_of(edges, [&](flow::EdgeId id) {
                return graph.edges[id].kind == kind && is_in_text(graph, graph.edges[id].from);
            });
        };
        const bool is_jumped_to = comes_by(flow::EdgeKind::jump) || comes_by(flow::EdgeKind::computed);
        if (is_jumped_to) return comes_by(flow::EdgeKind::next);
        if (edges.size() != 1 || graph.edges[edges[0]].kind != flow::EdgeKind::next) return false;
        node = graph.edges[edges[0]].from;
    }
    return false;
}

AlarmEnd find_alarm_end(const Program& program, const flow::Graph& graph, const Callees& callees,
                        const std::vector<bool>& reached, bool returns) {
    return Finder(program, graph, callees, reached).run(returns);
}

} // namespace maclint::dataflow
