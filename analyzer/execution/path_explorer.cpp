//! Depth first, the nearest way first; of ways that make no difference to the decisions to come only one.
#include "analyzer/execution/path_explorer.hpp"

#include "analyzer/flow/walk.hpp"
#include "analyzer/source/budget.hpp"

#include <algorithm>
#include <cassert>
#include <functional>
#include <limits>
#include <utility>

namespace maclint::execution {
namespace {

constexpr std::size_t most_legs = 8;
/// Work for one program, in all searches: thousands of findings in thousands of blocks are not each worth a
/// look at all of them.
constexpr std::size_t most_work = 40'000'000;
/// Assumptions, expressions, variables and edges that are looked at for one path.
constexpr std::size_t most_looked_at = 10'000'000;
constexpr std::size_t work_of_a_visit = 100;     ///< it takes as long as measuring 100 nodes
constexpr std::size_t work_of_a_cycles_node = 4; ///< likewise
/// Nogoods of one node and leg. Where there are more, one with the variables of all replaces them.
constexpr std::size_t most_sets = 4;
/// What failed after no more visits than these is not learnt: it is found again as cheaply.
constexpr std::size_t few_visits = 16;
constexpr std::uint32_t unreachable = std::numeric_limits<std::uint32_t>::max();

bool is_barred(std::span<const flow::NodeId> barred, flow::NodeId node) {
    return std::ranges::binary_search(barred, node);
}

/// Of every node, whether two ways may meet there, or begin as one: elsewhere nothing is the same again that
/// was not the same one node earlier.
std::vector<bool> where_ways_meet(const flow::Graph& graph) {
    std::vector<bool> meet(graph.nodes.size());
    for (flow::NodeId node = 0; node < meet.size(); ++node) {
        const auto& in = graph.in[node];
        meet[node] = in.size() != 1 || graph.out[graph.edges[in.front()].from].size() != 1;
    }
    return meet;
}

} // namespace

PathExplorer::PathExplorer(const ProgramAnalysis& analysis)
    : analysis_(analysis)
    , graph_(analysis.graph())
    , run_(analysis, looked_at_, most_looked_at)
    , rounds_(analysis)
    , ways_meet_(where_ways_meet(graph_)) {}

PathFound PathExplorer::find(std::span<const Leg> legs, std::size_t most_visits) {
    assert(!legs.empty() && legs.size() <= most_legs);
    if (is_spent()) return {.path = {}, .ends = {}, .visits = 0, .gave_up = true};
    legs_ = legs;
    measure(legs);
    work_ += legs.size() * graph_.nodes.size();
    choice_point_of_.assign(legs.size(), std::vector<std::uint32_t>(graph_.nodes.size(), 0));
    choice_points_.clear();
    frontier_.clear();
    nogoods_.clear();
    visits_ = 0;
    rounds_.forget_left_out();
    PathFound found;
    flow::NodeId from = 0;
    for (std::size_t each = 0; each < legs.size(); from = legs[each++].to)
        if (distance_[each][from] == unreachable) return found;
    const Budget budget(most_looked_at);
    bool arrived = arrive(0, 0, run_.at_start());
    while (!arrived && !choice_points_.empty()) {
        if (visits_ > most_visits || budget.is_spent() || is_spent()) {
            found.gave_up = true;
            break;
        }
        ChoicePoint& choice = choice_points_.back();
        if (frontier_.size() == choice.frontier_begin) {
            backtrack();
            continue;
        }
        const flow::EdgeId way = frontier_.back();
        frontier_.pop_back();
        // The run stands at the node that was run last: after going back that is another one.
        const auto next = run_.along(way, choice.after);
        if (!next) {
            note_closed(choice, graph_.edges[way]);
            continue;
        }
        choice.taken = way;
        arrived = arrive(graph_.edges[way].to, choice.leg, *next);
    }
    work_ += visits_ * work_of_a_visit;
    // Where the limit is met not all was asked on the way.
    if (arrived && budget.is_spent()) {
        arrived = false;
        found.gave_up = true;
    }
    if (arrived) found = path_gone();
    found.may_miss = !arrived && rounds_.left_out();
    found.visits = visits_;
    return found;
}

bool PathExplorer::is_spent() const {
    return work_ + looked_at_.done() + rounds_.measured() * work_of_a_cycles_node > most_work;
}

PathFound PathExplorer::path_gone() const {
    PathFound found;
    found.path.emplace();
    for (const ChoicePoint& choice : choice_points_) {
        found.ends.resize(choice.leg, found.path->size());
        if (choice.taken) found.path->push_back(*choice.taken);
    }
    found.ends.resize(legs_.size(), found.path->size());
    return found;
}

/// Finds out how far each node is from the end of each leg.
void PathExplorer::measure(std::span<const Leg> legs) {
    distance_.assign(legs.size(), std::vector<std::uint32_t>(graph_.nodes.size(), unreachable));
    for (std::size_t leg = 0; leg < legs.size(); ++leg) {
        std::vector<std::uint32_t>& distance = distance_[leg];
        distance[legs[leg].to] = 0;
        flow::walk<flow::Direction::backward>(
            graph_, {legs[leg].to}, [&](flow::EdgeId id, flow::NodeId from) {
                const flow::Edge& edge = graph_.edges[id];
                if (distance[from] != unreachable || !may_take(edge, id, legs[leg]))
                    return flow::Step::refuse;
                distance[from] = distance[edge.to] + 1;
                return flow::Step::go_on;
            });
    }
}

/// The first node of a leg may be barred: it has been passed.
bool PathExplorer::may_take(const flow::Edge& edge, flow::EdgeId id, const Leg& leg) const {
    return analysis_.data().passable(id) && (edge.to == leg.to || !is_barred(leg.barred, edge.to));
}

bool PathExplorer::arrive(flow::NodeId node, std::uint32_t leg, Point point) {
    const bool back_on_path = leg > 0 && is_on_path(node, leg - 1);
    while (node == legs_[leg].to) {
        if (++leg == legs_.size()) return true;
        if (distance_[leg][node] == unreachable) return false;
    }
    if (is_on_path(node, leg)) {
        note_in_the_way(node, leg);
        return false;
    }
    Justification of_rounds;
    point = after_rounds(node, leg, point, of_rounds);
    // Blocks that run once more make other values of the same symbols.
    if (back_on_path) PathRun::forget_assumptions(point);
    if (const auto [nogood, validity] = nogood_for(node, leg, point); nogood != nullptr) {
        add_reasons(choice_points_.back(), nogood->why);
        add_to_last(validity->justification, leg);
        add_to_last(of_rounds, leg);
        return false;
    }
    ++visits_;
    choice_points_.push_back(
        {node, leg, point, run_.run(node, point), frontier_.size(), visits_, std::move(of_rounds), {}});
    choice_point_of_[leg][node] = static_cast<std::uint32_t>(choice_points_.size());
    add_ways_from(node, leg);
    return false;
}

PathExplorer::Point PathExplorer::after_rounds(flow::NodeId node, std::uint32_t leg, Point point,
                                               Justification& justification) {
    const auto is_passed = [&](flow::NodeId each) { return is_on_path(each, leg); };
    const flow::NodeId first = leg == 0 ? 0 : legs_[leg - 1].to;
    if (const Changes* changes = rounds_.at(node, first, legs_[leg].barred, is_passed))
        point = run_.after_changes(*changes, point);
    for (const flow::NodeId passed : rounds_.in_the_way())
        justification.conflicts.add(choice_point_of_[leg][passed] - 1);
    if (rounds_.not_passed() != nullptr) justification.add_not_passed(rounds_.not_passed());
    return point;
}

/// What every path to the last choice point has passed is no conflict: the heads of loops that are entered
/// there alone, and where the leg begins.
void PathExplorer::note_in_the_way(flow::NodeId node, std::uint32_t leg) {
    const bool always =
        leg == 0 ? rounds_.heads_are_passed(choice_points_.back().node) : node == legs_[leg - 1].to;
    if (!always) choice_points_.back().justification.conflicts.add(choice_point_of_[leg][node] - 1);
}

/// Nearest to the end of the leg last, of equally near ones the first edge.
void PathExplorer::add_ways_from(flow::NodeId node, std::uint32_t leg) {
    const std::vector<std::uint32_t>& distance = distance_[leg];
    const auto first = static_cast<std::ptrdiff_t>(frontier_.size());
    looked_at_.allows(graph_.out[node].size());
    for (const flow::EdgeId id : graph_.out[node]) {
        const flow::Edge& edge = graph_.edges[id];
        if (distance[edge.to] == unreachable || !may_take(edge, id, legs_[leg])) continue;
        if (is_on_path(edge.to, leg))
            note_in_the_way(edge.to, leg);
        else
            frontier_.push_back(id);
    }
    const auto far_first = [&](flow::EdgeId id) { return std::pair(distance[graph_.edges[id].to], id); };
    std::ranges::sort(frontier_.begin() + first, frontier_.end(), std::greater{}, far_first);
}

void PathExplorer::backtrack() {
    ChoicePoint choice = std::move(choice_points_.back());
    choice_points_.pop_back();
    choice_point_of_[choice.leg][choice.node] = 0;
    choice.justification.conflicts.remove(
        choice_points_.size()); // where it is come to again it is not on the path
    VariableSet why = choice.reasons.empty() ? reasons().none() : choice.reasons;
    reasons().go_back_over(choice.node, why);
    if (ways_meet_[choice.node] && visits_ - choice.visit > few_visits) learn_nogood(choice, why);
    if (choice_points_.empty()) return;
    add_reasons(choice_points_.back(), why);
    add_to_last(choice.justification, choice.leg);
    add_to_last(choice.of_rounds, choice.leg);
    choice_points_.back().taken.reset();
}

/// To the last choice point, one of whose edges led to a node of that leg. What is not passed in a leg says
/// nothing of the leg before.
void PathExplorer::add_to_last(const Justification& justification, std::uint32_t leg) {
    ChoicePoint& choice = choice_points_.back();
    if (choice.leg == leg)
        choice.justification.add_all(justification);
    else
        choice.justification.conflicts.add_all(justification.conflicts);
}

void PathExplorer::Justification::add_all(const Justification& more) {
    conflicts.add_all(more.conflicts);
    for (const auto* nodes : more.not_passed) add_not_passed(nodes);
}

void PathExplorer::Justification::add_not_passed(const std::vector<flow::NodeId>* nodes) {
    if (std::ranges::find(not_passed, nodes) == not_passed.end()) not_passed.push_back(nodes);
}

const FailureReasons& PathExplorer::reasons() {
    if (!reasons_) reasons_.emplace(analysis_.program(), graph_, analysis_.data().callees(), looked_at_);
    return *reasons_;
}

/// The edge that was taken from the choice point has failed. What was decided there counts where it says
/// something of a value on which the failure depends.
void PathExplorer::add_reasons(ChoicePoint& choice, const VariableSet& more) {
    if (choice.reasons.empty()) choice.reasons = reasons().none();
    reasons().add_all(choice.reasons, more);
    const flow::Edge& way = graph_.edges[*choice.taken];
    if (!way.condition && !way.label) return;
    VariableSet decided = reasons().none();
    reasons().add_decision(way, decided);
    if (run_.share_a_value(choice.after, reasons().members(decided), reasons().members(more)))
        reasons().add_all(choice.reasons, decided);
}

void PathExplorer::note_closed(ChoicePoint& choice, const flow::Edge& way) {
    if (choice.reasons.empty()) choice.reasons = reasons().none();
    if (choice.after.state.reached)
        reasons().add_decision(way, choice.reasons);
    else
        reasons().add_returns(choice.node, choice.reasons);
}

void PathExplorer::learn_nogood(const ChoicePoint& choice, const VariableSet& why) {
    std::vector<Nogood>& nogoods = nogoods_[dataflow::side_by_side(choice.node, choice.leg)];
    auto nogood = std::ranges::find(nogoods, why, &Nogood::why);
    if (nogood == nogoods.end()) {
        VariableSet all = why;
        if (nogoods.size() == most_sets) {
            for (const Nogood& other : nogoods) reasons().add_all(all, other.why);
            nogoods.clear();
        }
        nogoods.push_back({all, reasons().members(all), {}});
        nogood = std::prev(nogoods.end());
    }
    const auto last = choice.justification.conflicts.last();
    nogood->fingerprints.insert_or_assign(
        run_.fingerprint(choice.before, nogood->variables),
        Validity{choice.justification, last ? choice_points_[*last].visit : 0});
}

bool PathExplorer::is_valid(const Validity& validity, std::uint32_t leg) const {
    const auto last = validity.justification.conflicts.last();
    if (last && (*last >= choice_points_.size() || choice_points_[*last].visit != validity.visit))
        return false;
    return std::ranges::none_of(
        validity.justification.not_passed, [&](const std::vector<flow::NodeId>* nodes) {
            return std::ranges::any_of(*nodes, [&](flow::NodeId node) { return is_on_path(node, leg); });
        });
}

std::pair<const PathExplorer::Nogood*, const PathExplorer::Validity*>
PathExplorer::nogood_for(flow::NodeId node, std::uint32_t leg, const Point& point) {
    if (nogoods_.empty() || !ways_meet_[node]) return {};
    const auto nogoods = nogoods_.find(dataflow::side_by_side(node, leg));
    if (nogoods == nogoods_.end()) return {};
    for (const Nogood& nogood : nogoods->second) {
        const auto known = nogood.fingerprints.find(run_.fingerprint(point, nogood.variables));
        if (known != nogood.fingerprints.end() && is_valid(known->second, leg))
            return {&nogood, &known->second};
    }
    return {};
}

} // namespace maclint::execution
