//! Goes through a program forward from its start, one decision after the other, and back to the last one that
//! can turn out otherwise where it cannot go on.
#pragma once

#include "analyzer/execution/conflict_set.hpp"
#include "analyzer/execution/failure_reasons.hpp"
#include "analyzer/execution/path_found.hpp"
#include "analyzer/execution/path_run.hpp"
#include "analyzer/execution/rounds.hpp"
#include "analyzer/execution/search_work.hpp"

#include <optional>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

namespace maclint::execution {

/// The search is depth first with learning. Each node on the path is a choice point, and its edges that were
/// not tried yet lie on the frontier, those of the last choice point last. The explorer takes the edge that
/// leads nearest to the end of the leg and runs the node behind it with unknowns. Where the frontier has no
/// edge of the last choice point left, that point failed: it is taken off the path, and the one before it
/// tries its next edge. Each failure has two parts. Its reasons are variables: those that the decisions
/// behind the point asked, followed back through the assignments. Its justification is what else it rests on:
/// the conflict set, choice points of the path that the search must not pass twice, and nodes that the path
/// has not passed. Both are handed to the choice point before, and learnt as a nogood: whoever comes to the
/// same node of the same leg with the same values of the reasons fails too, as long as the justification is
/// valid, and the search does not run it again. Loops are not run round by round, see Rounds.
///
/// What it learns of the program serves the next search, which finds the same as a new explorer would.
class PathExplorer {
  public:
    /// The analysis must outlive the explorer, and hold the facts Store and Clobber.
    explicit PathExplorer(const ProgramAnalysis& analysis);

    /// See PathSearch; gives up after `most_visits`.
    [[nodiscard]] PathFound find(std::span<const Leg> legs, std::size_t most_visits);

  private:
    using Point = PathRun::Point;
    /// What an answer rests on: choice points that are on the path, and nodes that are not, in the same leg.
    struct Justification {
        ConflictSet conflicts;
        dataflow::SmallVector<const std::vector<flow::NodeId>*, 1> not_passed; ///< lists of Rounds

        void add_all(const Justification& more);
        void add_not_passed(const std::vector<flow::NodeId>* nodes);
    };
    /// A node on the path, from which some edges may not have been tried yet.
    struct ChoicePoint {
        flow::NodeId node;
        std::uint32_t leg;
        Point before, after;
        std::size_t frontier_begin; ///< its edges begin there in `frontier_`, which holds those of all points
        std::size_t visit;          ///< its number among all visits of the search
        Justification of_rounds;    ///< of what rounds of loops made of `before`
        Justification justification; ///< of its edges that failed; itself may be one of the conflicts
        std::optional<flow::EdgeId> taken = {};
        /// Why edges that were tried have failed, after the node; empty: none was.
        VariableSet reasons = {};
    };

    void measure(std::span<const Leg> legs);
    [[nodiscard]] bool may_take(const flow::Edge& edge, flow::EdgeId id, const Leg& leg) const;
    /// Whether all legs have been gone.
    [[nodiscard]] bool arrive(flow::NodeId node, std::uint32_t leg, Point point);
    void backtrack();
    void add_to_last(const Justification& justification, std::uint32_t leg);
    /// Whether all the work that is allowed for the program has been done.
    [[nodiscard]] bool is_spent() const;
    [[nodiscard]] PathFound path_gone() const;
    [[nodiscard]] const FailureReasons& reasons();
    void add_reasons(ChoicePoint& choice, const VariableSet& more);
    void note_closed(ChoicePoint& choice, const flow::Edge& way);
    void learn_nogood(const ChoicePoint& choice, const VariableSet& why);
    struct Nogood;
    struct Validity;
    /// What was learnt there and forbids the point; nothing: it is to be tried.
    [[nodiscard]] std::pair<const Nogood*, const Validity*> nogood_for(flow::NodeId node, std::uint32_t leg,
                                                                       const Point& point);
    /// What rounds of loops make of the point at the node, and what that rests on.
    [[nodiscard]] Point after_rounds(flow::NodeId node, std::uint32_t leg, Point point,
                                     Justification& justification);
    /// An edge of the last choice point leads to a node that is on the path.
    void note_in_the_way(flow::NodeId node, std::uint32_t leg);
    void add_ways_from(flow::NodeId node, std::uint32_t leg);
    [[nodiscard]] bool is_on_path(flow::NodeId node, std::uint32_t leg) const {
        return choice_point_of_[leg][node] != 0;
    }

    const ProgramAnalysis& analysis_;
    const flow::Graph& graph_;
    SearchWork looked_at_; ///< in all searches
    PathRun run_;
    Rounds rounds_;
    std::span<const Leg> legs_;
    std::vector<std::vector<std::uint32_t>> distance_; ///< edges to the end of each leg, of every node
    std::vector<std::vector<std::uint32_t>>
        choice_point_of_; ///< of every node in each leg, one more than its number; 0: it is not on the path
    std::vector<bool> ways_meet_; ///< of every node: see where_ways_meet
    std::vector<ChoicePoint> choice_points_;
    std::vector<flow::EdgeId> frontier_; ///< not tried yet, of each choice point in turn, the next one last
    std::optional<FailureReasons> reasons_; ///< nothing: no way has failed in any search
    /// As long as the last of the conflicts is on the path, each of them is.
    struct Validity {
        Justification justification;
        std::size_t visit; ///< of the last conflict
    };
    [[nodiscard]] bool is_valid(const Validity& validity, std::uint32_t leg) const;
    /// No path leads on from points that agree in the variables, as long as that is valid.
    struct Nogood {
        VariableSet why;
        std::vector<Variable> variables;                          ///< those of `why`
        std::unordered_map<std::uint64_t, Validity> fingerprints; ///< of the points so far
    };
    std::unordered_map<std::uint64_t, std::vector<Nogood>> nogoods_; ///< in this search, by node and leg
    std::size_t visits_ = 0;
    std::size_t work_ = 0; ///< of all searches: nodes that were measured or visited, see `looked_at_` too
};

} // namespace maclint::execution
