//! What may have changed when a path comes to a node and what lies ahead was run before: a path passes each
//! node once, the rounds in between are not gone one by one.
#pragma once

#include "analyzer/dataflow/cycles.hpp"
#include "analyzer/execution/path_run.hpp"

#include <algorithm>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

namespace maclint::execution {

/// The cycles of a program. A path that passes a node any number of times ends with the same values as one
/// that stays once at the node while the cycles there change what they may: those that pass no node of the
/// path.
class Rounds {
  public:
    /// The analysis must outlive this, and hold the facts Store and Clobber.
    explicit Rounds(const ProgramAnalysis& analysis);

    /// What the cycles through the node change that pass no node of which `is_passed(node)` says so. nullptr:
    /// nothing, or one of their nodes is `barred` (sorted), as nobody knows how often they can go round
    /// without it. Valid as long as this is.
    template<class IsPassed>
    [[nodiscard]] const Changes* at(flow::NodeId node, std::span<const flow::NodeId> barred,
                                    const IsPassed& is_passed) {
        in_the_way_.clear();
        if (!entered_aside(node)) return leads_back_to(node) ? changes_of(headed_by(node), barred) : nullptr;
        passed_.assign(graph_.nodes.size(), false);
        for (flow::NodeId each = 0; each < passed_.size(); ++each) passed_[each] = is_passed(each);
        return changes_of(through(node), barred);
    }
    /// Nodes that the path had passed, and without which the last answer might have been another. That one
    /// more would take a barred node out of the cycles is not told.
    [[nodiscard]] std::span<const flow::NodeId> in_the_way() const { return in_the_way_; }
    /// Whether all paths from the program's start to the node pass the heads of all loops around it.
    [[nodiscard]] bool heads_are_passed(flow::NodeId node) { return !entered_aside(node); }
    /// How many nodes were looked at so far.
    [[nodiscard]] std::size_t measured() const { return measured_; }

  private:
    struct Cycle {
        std::vector<flow::NodeId> nodes; ///< empty: no edge leads back
        Changes changes;
    };

    /// Whether an edge does, in the order of the graph.
    [[nodiscard]] bool leads_back_to(flow::NodeId node) const {
        return std::ranges::any_of(graph_.in[node], [&](flow::EdgeId edge) {
            return graph_.order[graph_.edges[edge].from] >= graph_.order[node];
        });
    }
    /// The nodes that lead back to the node and come after it in the order of the graph: all that its cycles
    /// hold when a path can come to these nodes by way of it alone.
    [[nodiscard]] const Cycle& headed_by(flow::NodeId head);
    /// The nodes on cycles through the node over none that is `passed_`.
    [[nodiscard]] const Cycle& through(flow::NodeId node);
    /// Whether a path may come to the node inside a loop whose head it has not passed.
    [[nodiscard]] bool entered_aside(flow::NodeId node);
    [[nodiscard]] std::vector<bool> nodes_entered_aside() const;
    struct Loop {
        std::span<const flow::NodeId> nodes; ///< sorted
        flow::NodeId head;                   ///< the first of them in the order of the graph
    };
    [[nodiscard]] std::vector<Loop> loops_of(const dataflow::Cycles& cycles) const;
    [[nodiscard]] bool is_entered_aside(const Loop& loop, const flow::Components& components) const;
    [[nodiscard]] const Changes* changes_of(const Cycle& cycle, std::span<const flow::NodeId> barred);
    void find_changes(Cycle& cycle, flow::NodeId at);

    const ProgramAnalysis& analysis_;
    const flow::Graph& graph_;
    std::unordered_map<flow::NodeId, Cycle> by_head_;
    std::map<std::pair<flow::NodeId, std::vector<flow::NodeId>>, Cycle>
        by_nodes_;                                   ///< and the node they lead to
    std::optional<std::vector<bool>> entered_aside_; ///< of every node; found out when asked for
    std::vector<bool> passed_;                       ///< kept for its memory
    std::vector<flow::NodeId> in_the_way_;           ///< see there
    std::size_t measured_ = 0;
};

} // namespace maclint::execution
