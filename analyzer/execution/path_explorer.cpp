//! Depth first, the nearest way first; of ways that make no difference to the decisions to come only one.
#include "analyzer/execution/path_explorer.hpp"

#include "analyzer/flow/walk.hpp"
#include "analyzer/source/work_limit.hpp"

#include <algorithm>
#include <cassert>
#include <functional>
#include <limits>
#include <utility>

namespace maclint::execution {
namespace {

constexpr std::size_t most_legs = 8;
/// So much work is done for one program: thousands of findings in thousands of blocks are not each worth a
/// look at all of them.
constexpr std::size_t most_work = 40'000'000;
/// So many assumptions, expressions, variables and ways on are looked at for one path.
constexpr std::size_t most_looked_at = 10'000'000;
constexpr std::size_t work_of_a_visit = 100;     ///< as long as measuring so many nodes
constexpr std::size_t work_of_a_cycles_node = 4; ///< likewise
/// Of so many sets of reasons each is asked; where there are more, one of all their variables.
constexpr std::size_t most_sets = 4;
/// A failure that took no more visits below its node is not remembered: it is found again as cheaply.
constexpr std::size_t few_visits = 16;
constexpr std::uint32_t no_way = std::numeric_limits<std::uint32_t>::max();

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
    place_of_.assign(legs.size(), std::vector<std::uint32_t>(graph_.nodes.size(), 0));
    places_.clear();
    ways_.clear();
    failed_.clear();
    visits_ = 0;
    rounds_.forget_left_out();
    PathFound found;
    flow::NodeId from = 0;
    for (std::size_t each = 0; each < legs.size(); from = legs[each++].to)
        if (distance_[each][from] == no_way) return found;
    const WorkLimit limit(most_looked_at);
    bool arrived = arrive(0, 0, run_.at_start());
    while (!arrived && !places_.empty()) {
        if (visits_ > most_visits || limit.is_met() || is_spent()) {
            found.gave_up = true;
            break;
        }
        Place& place = places_.back();
        if (ways_.size() == place.ways) {
            go_back();
            continue;
        }
        const flow::EdgeId way = ways_.back();
        ways_.pop_back();
        // The run stands at the node that was run last: after going back that is another one.
        const auto next = run_.along(way, place.after);
        if (!next) {
            note_closed(place, graph_.edges[way]);
            continue;
        }
        place.taken = way;
        arrived = arrive(graph_.edges[way].to, place.leg, *next);
    }
    work_ += visits_ * work_of_a_visit;
    // Where the limit is met not all was asked on the way.
    if (arrived && limit.is_met()) {
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
    for (const Place& place : places_) {
        found.ends.resize(place.leg, found.path->size());
        if (place.taken) found.path->push_back(*place.taken);
    }
    found.ends.resize(legs_.size(), found.path->size());
    return found;
}

/// Finds out how far each node is from the end of each leg.
void PathExplorer::measure(std::span<const Leg> legs) {
    distance_.assign(legs.size(), std::vector<std::uint32_t>(graph_.nodes.size(), no_way));
    for (std::size_t leg = 0; leg < legs.size(); ++leg) {
        std::vector<std::uint32_t>& distance = distance_[leg];
        distance[legs[leg].to] = 0;
        flow::walk<flow::Direction::backward>(
            graph_, {legs[leg].to}, [&](flow::EdgeId id, flow::NodeId from) {
                const flow::Edge& edge = graph_.edges[id];
                if (distance[from] != no_way || !may_take(edge, id, legs[leg])) return flow::Step::refuse;
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
        if (distance_[leg][node] == no_way) return false;
    }
    if (is_on_path(node, leg)) {
        note_in_the_way(node, leg);
        return false;
    }
    Ground before_it;
    point = after_rounds(node, leg, point, before_it);
    // Blocks that run once more make other values of the same symbols.
    if (back_on_path) PathRun::forget_assumptions(point);
    if (const auto [failure, hold] = failed_before(node, leg, point); failure != nullptr) {
        add_reasons(places_.back(), failure->why);
        hand_back(hold->ground, leg);
        hand_back(before_it, leg);
        return false;
    }
    ++visits_;
    places_.push_back(
        {node, leg, point, run_.run(node, point), ways_.size(), visits_, std::move(before_it), {}});
    place_of_[leg][node] = static_cast<std::uint32_t>(places_.size());
    add_ways_from(node, leg);
    return false;
}

PathExplorer::Point PathExplorer::after_rounds(flow::NodeId node, std::uint32_t leg, Point point,
                                               Ground& ground) {
    const auto is_passed = [&](flow::NodeId each) { return is_on_path(each, leg); };
    const flow::NodeId first = leg == 0 ? 0 : legs_[leg - 1].to;
    if (const Changes* changes = rounds_.at(node, first, legs_[leg].barred, is_passed))
        point = run_.after_changes(*changes, point);
    for (const flow::NodeId passed : rounds_.in_the_way()) ground.places.add(place_of_[leg][passed] - 1);
    if (rounds_.not_passed() != nullptr) ground.add_not_passed(rounds_.not_passed());
    return point;
}

/// What every path to the last place has passed need not be told: the heads of loops that are entered there
/// alone, and where the leg begins.
void PathExplorer::note_in_the_way(flow::NodeId node, std::uint32_t leg) {
    const bool always = leg == 0 ? rounds_.heads_are_passed(places_.back().node) : node == legs_[leg - 1].to;
    if (!always) places_.back().ground.places.add(place_of_[leg][node] - 1);
}

/// Nearest to the end of the leg last, of equally near ones the first edge.
void PathExplorer::add_ways_from(flow::NodeId node, std::uint32_t leg) {
    const std::vector<std::uint32_t>& distance = distance_[leg];
    const auto first = static_cast<std::ptrdiff_t>(ways_.size());
    looked_at_.allows(graph_.out[node].size());
    for (const flow::EdgeId id : graph_.out[node]) {
        const flow::Edge& edge = graph_.edges[id];
        if (distance[edge.to] == no_way || !may_take(edge, id, legs_[leg])) continue;
        if (is_on_path(edge.to, leg))
            note_in_the_way(edge.to, leg);
        else
            ways_.push_back(id);
    }
    const auto far_first = [&](flow::EdgeId id) { return std::pair(distance[graph_.edges[id].to], id); };
    std::ranges::sort(ways_.begin() + first, ways_.end(), std::greater{}, far_first);
}

void PathExplorer::go_back() {
    Place place = std::move(places_.back());
    places_.pop_back();
    place_of_[place.leg][place.node] = 0;
    place.ground.places.remove(places_.size()); // where it is come to again it is not on the path
    VariableSet why = place.reasons.empty() ? reasons().none() : place.reasons;
    reasons().go_back_over(place.node, why);
    if (ways_meet_[place.node] && visits_ - place.visit > few_visits) remember_failure(place, why);
    if (places_.empty()) return;
    add_reasons(places_.back(), why);
    hand_back(place.ground, place.leg);
    hand_back(place.before_it, place.leg);
    places_.back().taken.reset();
}

/// To the last place, one of whose ways led to a place of that leg. Before a leg begins it has passed
/// nothing.
void PathExplorer::hand_back(const Ground& ground, std::uint32_t leg) {
    Place& place = places_.back();
    if (place.leg == leg)
        place.ground.add_all(ground);
    else
        place.ground.places.add_all(ground.places);
}

void PathExplorer::Ground::add_all(const Ground& more) {
    places.add_all(more.places);
    for (const auto* nodes : more.not_passed) add_not_passed(nodes);
}

void PathExplorer::Ground::add_not_passed(const std::vector<flow::NodeId>* nodes) {
    if (std::ranges::find(not_passed, nodes) == not_passed.end()) not_passed.push_back(nodes);
}

const FailureReasons& PathExplorer::reasons() {
    if (!reasons_) reasons_.emplace(analysis_.program(), graph_, analysis_.data().callees(), looked_at_);
    return *reasons_;
}

/// The way that was taken from the place has failed. What was decided there counts where it says something of
/// a value on which the failure depends.
void PathExplorer::add_reasons(Place& place, const VariableSet& more) {
    if (place.reasons.empty()) place.reasons = reasons().none();
    reasons().add_all(place.reasons, more);
    const flow::Edge& way = graph_.edges[*place.taken];
    if (!way.condition && !way.label) return;
    VariableSet decided = reasons().none();
    reasons().add_decision(way, decided);
    if (run_.share_a_value(place.after, reasons().members(decided), reasons().members(more)))
        reasons().add_all(place.reasons, decided);
}

void PathExplorer::note_closed(Place& place, const flow::Edge& way) {
    if (place.reasons.empty()) place.reasons = reasons().none();
    if (place.after.state.reached)
        reasons().add_decision(way, place.reasons);
    else
        reasons().add_returns(place.node, place.reasons);
}

void PathExplorer::remember_failure(const Place& place, const VariableSet& why) {
    std::vector<Failure>& failures = failed_[dataflow::side_by_side(place.node, place.leg)];
    auto failure = std::ranges::find(failures, why, &Failure::why);
    if (failure == failures.end()) {
        VariableSet all = why;
        if (failures.size() == most_sets) {
            for (const Failure& other : failures) reasons().add_all(all, other.why);
            failures.clear();
        }
        failures.push_back({all, reasons().members(all), {}});
        failure = std::prev(failures.end());
    }
    const auto last = place.ground.places.last();
    failure->fingerprints.insert_or_assign(run_.fingerprint(place.before, failure->variables),
                                           Hold{place.ground, last ? places_[*last].visit : 0});
}

bool PathExplorer::still_holds(const Hold& hold, std::uint32_t leg) const {
    const auto last = hold.ground.places.last();
    if (last && (*last >= places_.size() || places_[*last].visit != hold.visit)) return false;
    return std::ranges::none_of(hold.ground.not_passed, [&](const std::vector<flow::NodeId>* nodes) {
        return std::ranges::any_of(*nodes, [&](flow::NodeId node) { return is_on_path(node, leg); });
    });
}

std::pair<const PathExplorer::Failure*, const PathExplorer::Hold*>
PathExplorer::failed_before(flow::NodeId node, std::uint32_t leg, const Point& point) {
    if (failed_.empty() || !ways_meet_[node]) return {};
    const auto failures = failed_.find(dataflow::side_by_side(node, leg));
    if (failures == failed_.end()) return {};
    for (const Failure& failure : failures->second) {
        const auto known = failure.fingerprints.find(run_.fingerprint(point, failure.variables));
        if (known != failure.fingerprints.end() && still_holds(known->second, leg))
            return {&failure, &known->second};
    }
    return {};
}

} // namespace maclint::execution
