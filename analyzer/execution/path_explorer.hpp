//! Goes through a program forward from its start, one decision after the other, and back to the last one that
//! can turn out otherwise where it cannot go on.
#pragma once

#include "analyzer/execution/failure_reasons.hpp"
#include "analyzer/execution/path_found.hpp"
#include "analyzer/execution/path_run.hpp"
#include "analyzer/execution/place_set.hpp"
#include "analyzer/execution/rounds.hpp"
#include "analyzer/execution/search_work.hpp"

#include <optional>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

namespace maclint::execution {

/// What it learns of the program serves the next search, which finds the same as a new explorer would.
class PathExplorer {
  public:
    /// The analysis must outlive the explorer, and hold the facts Store and Clobber.
    explicit PathExplorer(const ProgramAnalysis& analysis);

    /// See PathSearch; gives up after `most_visits`.
    [[nodiscard]] PathFound find(std::span<const Leg> legs, std::size_t most_visits);

  private:
    using Point = PathRun::Point;
    /// What an answer hangs on: places that are on the path, and nodes that are not, in the same leg.
    struct Ground {
        PlaceSet places;
        dataflow::SmallVector<const std::vector<flow::NodeId>*, 1> not_passed; ///< lists of Rounds

        void add_all(const Ground& more);
        void add_not_passed(const std::vector<flow::NodeId>* nodes);
    };
    /// A node on the path, and the ways on from there that were not tried yet.
    struct Place {
        flow::NodeId node;
        std::uint32_t leg;
        Point before, after;
        std::size_t ways;  ///< so many of all `ways_` are those of nodes before
        std::size_t visit; ///< its number among all visits of the search
        Ground before_it;  ///< of `before`
        Ground ground;     ///< of its ways that do not lead on; itself may be one of the places
        std::optional<flow::EdgeId> taken = {};
        /// Why ways that were tried do not lead on, after the node; empty: none was.
        VariableSet reasons = {};
    };

    void measure(std::span<const Leg> legs);
    [[nodiscard]] bool may_take(const flow::Edge& edge, flow::EdgeId id, const Leg& leg) const;
    /// Whether all legs have been gone.
    [[nodiscard]] bool arrive(flow::NodeId node, std::uint32_t leg, Point point);
    void go_back();
    void hand_back(const Ground& ground, std::uint32_t leg);
    /// Whether all the work that is allowed for the program has been done.
    [[nodiscard]] bool is_spent() const;
    [[nodiscard]] PathFound path_gone() const;
    [[nodiscard]] const FailureReasons& reasons();
    void add_reasons(Place& place, const VariableSet& more);
    void note_closed(Place& place, const flow::Edge& way);
    void remember_failure(const Place& place, const VariableSet& why);
    struct Failure;
    struct Hold;
    /// A failure from there, and what it hangs on, where all that counts was the same; nothing: there was
    /// none.
    [[nodiscard]] std::pair<const Failure*, const Hold*> failed_before(flow::NodeId node, std::uint32_t leg,
                                                                       const Point& point);
    /// What rounds of loops make of the point at the node, and on what ground.
    [[nodiscard]] Point after_rounds(flow::NodeId node, std::uint32_t leg, Point point, Ground& ground);
    /// A way from the last place leads to a node that is on the path.
    void note_in_the_way(flow::NodeId node, std::uint32_t leg);
    void add_ways_from(flow::NodeId node, std::uint32_t leg);
    [[nodiscard]] bool is_on_path(flow::NodeId node, std::uint32_t leg) const {
        return place_of_[leg][node] != 0;
    }

    const ProgramAnalysis& analysis_;
    const flow::Graph& graph_;
    SearchWork looked_at_; ///< in all searches
    PathRun run_;
    Rounds rounds_;
    std::span<const Leg> legs_;
    std::vector<std::vector<std::uint32_t>> distance_; ///< edges to the end of each leg, of every node
    std::vector<std::vector<std::uint32_t>>
        place_of_; ///< of every node in each leg, one more than its number; 0: it is not on the path
    std::vector<bool> ways_meet_; ///< of every node: see ways_meet
    std::vector<Place> places_;
    std::vector<flow::EdgeId> ways_;        ///< not tried yet, of each place in turn, the next one last
    std::optional<FailureReasons> reasons_; ///< nothing: no way has failed in any search
    /// A failure holds as long as the last of the places, and so each of them, is on the path.
    struct Hold {
        Ground ground;
        std::size_t visit; ///< of the last place
    };
    [[nodiscard]] bool still_holds(const Hold& hold, std::uint32_t leg) const;
    /// No way leads on from points that agree in the variables, as long as that holds.
    struct Failure {
        VariableSet why;
        std::vector<Variable> variables;                      ///< those of `why`
        std::unordered_map<std::uint64_t, Hold> fingerprints; ///< of the points so far
    };
    std::unordered_map<std::uint64_t, std::vector<Failure>> failed_; ///< in this search, by node and leg
    std::size_t visits_ = 0;
    std::size_t work_ = 0; ///< of all searches: nodes that were measured or visited, see `looked_at_` too
};

} // namespace maclint::execution
