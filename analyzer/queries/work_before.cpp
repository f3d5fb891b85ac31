//! Walks back from a node.
#include "analyzer/queries/work_before.hpp"

#include "analyzer/flow/walk.hpp"
#include "analyzer/program/block_view.hpp"
#include "analyzer/queries/callers.hpp"

#include <variant>
#include <vector>

namespace maclint::queries {
namespace {

bool works(const ProgramAnalysis& analysis, flow::NodeId id) {
    const flow::Node& node = analysis.graph().nodes[id];
    if (node.is_run) return moves(analysis.program(), node.stretch());
    for (Id effect = node.effects.first; effect < node.effects.first + node.effects.count; ++effect) {
        const auto& what = analysis.program().effects[effect].what;
        if (std::holds_alternative<Motion>(what) || std::holds_alternative<ToolChange>(what)) return true;
        const CallSite* site = std::holds_alternative<Call>(what) ? analysis.call_at(effect) : nullptr;
        const ProgramAnalysis* called = site == nullptr ? nullptr : called_program(analysis, *site);
        if (called != nullptr && !site->in_cycle && called->summary().alarm_end.works) return true;
    }
    return false;
}

} // namespace

bool may_have_worked_before(const ProgramAnalysis& analysis, flow::NodeId node) {
    // Between the start and its first time: a loop that begins with the node works behind it.
    if (node == 0) return false;
    std::vector<bool> before(analysis.graph().nodes.size(), false);
    before[0] = true;
    flow::walk<flow::Direction::forward>(analysis.graph(), {0}, [&](flow::EdgeId edge, flow::NodeId to) {
        if (to == node || !analysis.data().passable(edge)) return flow::Step::refuse;
        before[to] = true;
        return flow::Step::go_on;
    });
    bool worked = false;
    flow::walk<flow::Direction::backward>(analysis.graph(), {node},
                                          [&](flow::EdgeId edge, flow::NodeId from) {
                                              if (worked || !before[from] || !analysis.data().passable(edge))
                                                  return flow::Step::refuse;
                                              worked = works(analysis, from);
                                              return flow::Step::go_on;
                                          });
    return worked;
}

} // namespace maclint::queries
