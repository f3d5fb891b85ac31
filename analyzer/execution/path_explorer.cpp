//! Depth first, the nearest way first; of ways that make no difference to the decisions to come only one.
#include "analyzer/execution/path_explorer.hpp"

#include "analyzer/flow/walk.hpp"

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
constexpr std::size_t work_of_a_visit = 100;     ///< as long as measuring so many nodes
constexpr std::size_t work_of_a_cycles_node = 4; ///< likewise
/// So many nodes of what decisions depend on are kept for the next search.
constexpr std::size_t most_kept = 1'000'000;
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
    , run_(analysis)
    , rounds_(analysis)
    , ways_meet_(where_ways_meet(graph_)) {}

PathFound PathExplorer::find(std::span<const Leg> legs, std::size_t most_visits) {
    assert(!legs.empty() && legs.size() <= most_legs);
    if (is_spent()) return {.path = {}, .ends = {}, .visits = 0, .gave_up = true};
    legs_ = legs;
    measure(legs);
    work_ += legs.size() * graph_.nodes.size();
    on_path_.assign(graph_.nodes.size(), 0);
    places_.clear();
    ways_.clear();
    failed_.clear();
    ahead_ = nullptr;
    visits_ = 0;
    PathFound found;
    flow::NodeId from = 0;
    for (std::size_t each = 0; each < legs.size(); from = legs[each++].to)
        if (distance_[each][from] == no_way) return found;
    bool arrived = arrive(0, 0, run_.at_start());
    while (!arrived && !places_.empty()) {
        if (visits_ > most_visits || is_spent()) {
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
        if (!next) continue;
        place.taken = way;
        arrived = arrive(graph_.edges[way].to, place.leg, *next);
    }
    work_ += visits_ * work_of_a_visit;
    if (arrived) found = path_gone();
    found.visits = visits_;
    return found;
}

bool PathExplorer::is_spent() const { return work_ + rounds_.measured() * work_of_a_cycles_node > most_work; }

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
    if (is_on_path(node, leg)) return false;
    const auto is_passed = [&](flow::NodeId each) { return is_on_path(each, leg); };
    if (const Changes* changes = rounds_.at(node, legs_[leg].barred, is_passed))
        point = run_.after_changes(*changes, point);
    // Blocks that run once more make other values of the same symbols.
    if (back_on_path) PathRun::forget_assumptions(point);
    std::uint64_t fingerprint = 0;
    if (ahead_ != nullptr && ways_meet_[node] && failed_before(node, leg, point, fingerprint)) return false;
    ++visits_;
    on_path_[node] = static_cast<std::uint8_t>(on_path_[node] | 1U << leg);
    places_.push_back({node, leg, run_.run(node, point), ways_.size(), {}, fingerprint});
    add_ways_from(node, leg);
    return false;
}

/// Nearest to the end of the leg last, of equally near ones the first edge.
void PathExplorer::add_ways_from(flow::NodeId node, std::uint32_t leg) {
    const std::vector<std::uint32_t>& distance = distance_[leg];
    const auto first = static_cast<std::ptrdiff_t>(ways_.size());
    for (const flow::EdgeId id : graph_.out[node]) {
        const flow::Edge& edge = graph_.edges[id];
        if (distance[edge.to] != no_way && may_take(edge, id, legs_[leg]) && !is_on_path(edge.to, leg))
            ways_.push_back(id);
    }
    const auto far_first = [&](flow::EdgeId id) { return std::pair(distance[graph_.edges[id].to], id); };
    std::ranges::sort(ways_.begin() + first, ways_.end(), std::greater{}, far_first);
}

void PathExplorer::go_back() {
    if (ahead_ == nullptr) ahead_ = &deciding_on_the_way_to(legs_.back().to);
    const Place& place = places_.back();
    if (place.fingerprint != 0) failed_.insert(place.fingerprint);
    on_path_[place.node] = static_cast<std::uint8_t>(on_path_[place.node] & ~(1U << place.leg));
    places_.pop_back();
    if (!places_.empty()) places_.back().taken.reset();
}

PathExplorer::Deciding& PathExplorer::deciding_on_the_way_to(flow::NodeId goal) {
    const auto known = deciding_.find(goal);
    if (known != deciding_.end()) return known->second;
    if ((deciding_.size() + 1) * graph_.nodes.size() > most_kept) deciding_.clear();
    const dataflow::Callees& callees = analysis_.data().callees();
    auto decisions = dataflow::Liveness::of_decisions(analysis_.program(), graph_, callees, goal);
    return deciding_.emplace(goal, Deciding{std::move(decisions), {}}).first->second;
}

bool PathExplorer::failed_before(flow::NodeId node, std::uint32_t leg, const Point& point,
                                 std::uint64_t& fingerprint) {
    const auto [deciding, fresh] = ahead_->before.try_emplace(node);
    if (fresh) deciding->second = ahead_->decisions.live_before(node);
    fingerprint =
        dataflow::mix(run_.fingerprint(point, deciding->second), dataflow::side_by_side(node, leg)) | 1U;
    return failed_.contains(fingerprint);
}

} // namespace maclint::execution
