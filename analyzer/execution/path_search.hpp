//! Looks for a path that the control can take: forward from the program's start, one decision after the
//! other, back to the last one that can turn out otherwise where it cannot go on.
#pragma once

#include "analyzer/dataflow/solver/liveness.hpp"
#include "analyzer/execution/path_run.hpp"

#include <optional>
#include <span>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

namespace maclint::execution {

/// A part of a path: to a node, over none of the nodes in between that are `barred` (sorted).
struct Leg {
    flow::NodeId to;
    std::span<const flow::NodeId> barred;
};

struct PathFound {
    std::optional<std::vector<flow::EdgeId>> path; ///< from the program's start
    std::vector<std::size_t> ends;                 ///< of each leg: how many edges of the path lead there
    bool gave_up = false; ///< none was found among as many as were tried; there may be one
};

class PathSearch {
  public:
    /// The analysis must outlive the search, and hold the facts Store and Clobber.
    explicit PathSearch(const ProgramAnalysis& analysis);

    /// A path from the program's start along all legs, each edge of which can be taken by who came this way.
    /// Loops on it are left after any number of rounds, unless a barred node stands in one: that one is
    /// passed without a round.
    [[nodiscard]] PathFound find(std::span<const Leg> legs);

  private:
    using Point = PathRun::Point;
    /// A node on the path, and the ways on from there that were not tried yet.
    struct Place {
        flow::NodeId node;
        std::uint32_t leg;
        Point after;
        std::vector<flow::EdgeId> ways; ///< the next one last
        std::optional<flow::EdgeId> taken;
        std::uint64_t fingerprint; ///< of the point before the node; 0: not asked for
    };

    void measure(std::span<const Leg> legs);
    [[nodiscard]] bool may_take(const flow::Edge& edge, flow::EdgeId id, const Leg& leg) const;
    /// Whether all legs have been gone.
    [[nodiscard]] bool arrive(flow::NodeId node, std::uint32_t leg, Point point);
    void go_back();
    [[nodiscard]] PathFound path_gone() const;
    [[nodiscard]] bool failed_before(flow::NodeId node, std::uint32_t leg, const Point& point,
                                     std::uint64_t& fingerprint);
    [[nodiscard]] std::vector<flow::EdgeId> ways_from(flow::NodeId node, std::uint32_t leg) const;
    [[nodiscard]] const Changes* changes_of_rounds(flow::NodeId head, std::span<const flow::NodeId> barred);
    [[nodiscard]] bool is_on_path(flow::NodeId node, std::uint32_t leg) const {
        return (on_path_[node] >> leg & 1U) != 0;
    }

    /// The nodes of a loop, and what they change.
    struct Rounds {
        std::vector<flow::NodeId> nodes; ///< sorted; empty: no edge leads back
        Changes changes;
    };
    [[nodiscard]] const Rounds& rounds_of(flow::NodeId head);
    void collect_changes(Rounds& rounds) const;

    const ProgramAnalysis& analysis_;
    const flow::Graph& graph_;
    PathRun run_;
    std::span<const Leg> legs_;
    std::vector<std::vector<std::uint32_t>> distance_; ///< edges to the end of each leg, of every node
    std::vector<std::uint8_t> on_path_;                ///< of every node, a bit for each leg
    std::vector<Place> places_;
    std::unordered_map<flow::NodeId, Rounds> rounds_;
    std::optional<dataflow::Liveness> decisions_;                      ///< once a way has failed
    std::unordered_map<flow::NodeId, std::vector<Variable>> deciding_; ///< before a node
    std::unordered_set<std::uint64_t> failed_; ///< fingerprints from which no way leads on
    std::size_t visits_ = 0, visits_in_all_ = 0;
};

} // namespace maclint::execution
