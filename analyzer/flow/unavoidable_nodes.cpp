//! On a shortest path to an exit they are the nodes that no other path jumps over.
#include "analyzer/flow/unavoidable_nodes.hpp"

#include <algorithm>
#include <limits>
#include <optional>

namespace maclint::flow {
namespace {

constexpr EdgeId none = std::numeric_limits<EdgeId>::max();

class UnavoidableNodes {
  public:
    UnavoidableNodes(std::size_t nodes, std::span<const Edge> edges, const EdgesByNode& out)
        : nodes_(nodes)
        , edges_(edges)
        , out_(out)
        , leaves_(nodes, false) {}

    std::vector<bool> run(std::span<const Exit> exits) {
        const std::vector<NodeId> path = shortest_to(exits);
        std::vector<bool> unavoidable(nodes_, false);
        std::vector<std::size_t> place(nodes_, path.size()); // on the path; others have none
        for (std::size_t i = 0; i < path.size(); ++i) place[path[i]] = i;
        std::vector<bool> met(nodes_, false);
        std::size_t farthest = 0;
        for (std::size_t i = 0; i < path.size(); ++i) {
            unavoidable[path[i]] = farthest == i;
            farthest = std::max(farthest, farthest_from(path[i], place, path.size(), met));
        }
        return unavoidable;
    }

  private:
    /// To the nearest exit that is no alarm, else to the nearest alarm; empty where there is none.
    std::vector<NodeId> shortest_to(std::span<const Exit> exits) {
        std::vector<NodeId> nearest{0};
        std::vector<EdgeId> came_by(nodes_, none);
        std::vector<bool> met(nodes_, false);
        met[0] = true;
        for (std::size_t i = 0; i < nearest.size(); ++i)
            for (const EdgeId id : out_[nearest[i]])
                if (const NodeId to = edges_[id].to; !met[to]) {
                    met[to] = true;
                    came_by[to] = id;
                    nearest.push_back(to);
                }
        for (const bool alarms : {false, true}) {
            for (const Exit& exit : exits)
                if ((exit.kind == ExitKind::alarm) == alarms) leaves_[exit.node] = true;
            const auto end = std::ranges::find_if(nearest, [this](NodeId node) { return leaves_[node]; });
            if (end != nearest.end()) return path_to(*end, came_by);
        }
        return {};
    }

    [[nodiscard]] std::vector<NodeId> path_to(NodeId end, const std::vector<EdgeId>& came_by) const {
        std::vector<NodeId> path{end};
        while (came_by[path.back()] != none) path.push_back(edges_[came_by[path.back()]].from);
        std::ranges::reverse(path);
        return path;
    }

    /// The last place on the path to which nodes lead that no walk before has met; `beyond` it is an exit.
    std::size_t farthest_from(NodeId start, const std::vector<std::size_t>& place, std::size_t beyond,
                              std::vector<bool>& met) const {
        std::size_t farthest = leaves_[start] ? beyond : 0;
        std::vector<NodeId> pending{start};
        while (!pending.empty()) {
            const NodeId node = pending.back();
            pending.pop_back();
            for (const EdgeId id : out_[node]) {
                const NodeId to = edges_[id].to;
                if (place[to] < beyond) {
                    farthest = std::max(farthest, place[to]);
                } else if (!met[to]) {
                    met[to] = true;
                    if (leaves_[to]) farthest = beyond;
                    pending.push_back(to);
                }
            }
        }
        return farthest;
    }

    std::size_t nodes_;
    std::span<const Edge> edges_;
    const EdgesByNode& out_;
    std::vector<bool> leaves_;
};

} // namespace

std::vector<bool> unavoidable_nodes(std::size_t nodes, std::span<const Edge> edges, const EdgesByNode& out,
                                    std::span<const Exit> exits) {
    return UnavoidableNodes(nodes, edges, out).run(exits);
}

} // namespace maclint::flow
