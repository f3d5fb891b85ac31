//! What rounds of loops may have changed when a path comes to a node. A path passes each node once, and
//! rounds are not gone one by one: what they change counts as changed, in whatever way.
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

/// The cycles of a program. A path may pass a node any number of times. It ends with values that another path
/// has, too, which passes the node once and lets the cycles there change whatever they may. Only cycles over
/// no node of the path count.
class Rounds {
  public:
    /// The analysis must outlive this, and hold the facts Store and Clobber.
    explicit Rounds(const ProgramAnalysis& analysis);

    /// What the cycles through the node change, on a path that begins at `first`. Cycles over a node with
    /// `is_passed(node)` do not count. nullptr: nothing changes, or one of their nodes is `barred` (sorted),
    /// as it is unknown how often they can go round without it. Valid as long as this object.
    template<class IsPassed>
    [[nodiscard]] const Changes* at(flow::NodeId node, flow::NodeId first,
                                    std::span<const flow::NodeId> barred, const IsPassed& is_passed) {
        in_the_way_.clear();
        not_passed_ = nullptr;
        if (!entered_aside(node) && !began_inside(node, first, is_passed))
            return leads_back_to(node) ? changes_of(headed_by(node), barred) : nullptr;
        if (node != first && !is_come_to_from_elsewhere(node, is_passed)) return nullptr;
        passed_.assign(graph_.nodes.size(), false);
        for (flow::NodeId each = 0; each < passed_.size(); ++each) passed_[each] = is_passed(each);
        const Cycle& cycle = through(node);
        const Changes* changes = changes_of(cycle, barred);
        if (changes == nullptr && !cycle.nodes.empty()) not_passed_ = &cycle.nodes;
        return changes;
    }
    /// Nodes that the path had passed, and that may have made a difference to the last answer.
    [[nodiscard]] std::span<const flow::NodeId> in_the_way() const { return in_the_way_; }
    /// Where a barred node was the reason for the last answer: nodes that the path had not passed. Had it
    /// passed one, the answer might have been another. Valid as long as this object; nullptr: there are none.
    [[nodiscard]] const std::vector<flow::NodeId>* not_passed() const { return not_passed_; }
    /// Whether all paths from the program's start to the node pass the heads of all loops around it.
    [[nodiscard]] bool heads_are_passed(flow::NodeId node) { return !entered_aside(node); }
    /// Whether an answer left out rounds that can be gone, so that paths may be missed. It does where a round
    /// leads around a barred node of its cycle, or over a node of the path, or where there are too many
    /// loops.
    [[nodiscard]] bool left_out() const { return left_out_; }
    void forget_left_out() { left_out_ = false; }
    /// How many nodes were looked at so far.
    [[nodiscard]] std::size_t measured() const { return measured_; }

  private:
    struct Cycle {
        std::vector<flow::NodeId> nodes; ///< sorted; empty: no edge leads back
        Changes changes;
    };

    /// Whether an edge does, in the order of the graph.
    [[nodiscard]] bool leads_back_to(flow::NodeId node) const {
        return std::ranges::any_of(graph_.in[node], [&](flow::EdgeId edge) {
            return graph_.order[graph_.edges[edge].from] >= graph_.order[node];
        });
    }
    /// Whether an edge leads there from a node of its loop that the path has not passed. If not, the nodes
    /// that it has passed are in the way.
    template<class IsPassed>
    [[nodiscard]] bool is_come_to_from_elsewhere(flow::NodeId node, const IsPassed& is_passed) {
        std::vector<flow::NodeId> passed;
        for (const flow::EdgeId edge : graph_.in[node]) {
            const flow::NodeId from = graph_.edges[edge].from;
            if (!is_passed(from)) return true;
            passed.push_back(from);
        }
        // Where only one edge leads there, the path has come along it.
        if (passed.size() > 1) in_the_way_ = std::move(passed);
        return false;
    }
    /// Whether the path began in the middle of a loop that holds the node, and has not come to its head.
    template<class IsPassed>
    [[nodiscard]] bool began_inside(flow::NodeId node, flow::NodeId first, const IsPassed& is_passed) {
        for (auto head = head_around(first); head; head = head_around(*head))
            if (!is_passed(*head) && is_in_loop_of(*head, node)) return true;
        return false;
    }
    [[nodiscard]] bool is_in_loop_of(flow::NodeId head, flow::NodeId node) {
        for (std::optional<flow::NodeId> around = node; around; around = head_around(*around))
            if (*around == head) return true;
        return false;
    }
    /// The head of the innermost loop around the node that it is not the head of.
    [[nodiscard]] std::optional<flow::NodeId> head_around(flow::NodeId node);
    /// The nodes that lead back to the node and come after it in the order of the graph: all that its cycles
    /// hold when a path can come to these nodes by way of it alone.
    [[nodiscard]] const Cycle& headed_by(flow::NodeId head);
    /// The nodes on cycles through the node over none that is `passed_`.
    [[nodiscard]] const Cycle& through(flow::NodeId node);
    /// Whether a path may come to the node inside a loop whose head it has not passed.
    [[nodiscard]] bool entered_aside(flow::NodeId node);
    struct Nesting {
        std::vector<bool> entered_aside; ///< of every node; empty: none is, or nobody asks
        /// Of every node, see head_around; empty: there are no loops.
        std::vector<std::optional<flow::NodeId>> head_around;
        bool too_many = false; ///< to ask of each node on each path whether it is entered aside
    };
    [[nodiscard]] const Nesting& nesting();
    [[nodiscard]] Nesting find_nesting() const;
    struct Loop {
        std::span<const flow::NodeId> nodes; ///< sorted
        flow::NodeId head;                   ///< the first of them in the order of the graph
    };
    [[nodiscard]] std::vector<Loop> loops_of(const dataflow::Cycles& cycles) const;
    [[nodiscard]] bool is_entered_aside(const Loop& loop, const flow::Components& components) const;
    [[nodiscard]] const Changes* changes_of(const Cycle& cycle, std::span<const flow::NodeId> barred);
    [[nodiscard]] bool leads_around(const Cycle& cycle, std::span<const flow::NodeId> barred) const;
    void find_changes(Cycle& cycle, flow::NodeId at);

    const ProgramAnalysis& analysis_;
    const flow::Graph& graph_;
    std::unordered_map<flow::NodeId, Cycle> by_head_;
    std::map<std::pair<flow::NodeId, std::vector<flow::NodeId>>, Cycle>
        by_nodes_;                                          ///< and the node they lead to
    std::optional<Nesting> nesting_;                        ///< of the loops; found out when asked for
    std::vector<bool> passed_;                              ///< kept for its memory
    std::vector<flow::NodeId> in_the_way_;                  ///< see there
    const std::vector<flow::NodeId>* not_passed_ = nullptr; ///< see there
    bool left_out_ = false;                                 ///< see there
    std::size_t measured_ = 0;
};

} // namespace maclint::execution
