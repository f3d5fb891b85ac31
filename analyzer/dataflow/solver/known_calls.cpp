//! Calls that end in an alarm for the numbers that they are given: they do not come back.
#include "analyzer/dataflow/solver/known_calls.hpp"

#include "analyzer/dataflow/solver/analysis.hpp"
#include "analyzer/dataflow/solver/state_domain.hpp"
#include "analyzer/dataflow/solver/transfer.hpp"
#include "analyzer/flow/solve.hpp"
#include "analyzer/flow/walk.hpp"
#include "analyzer/program/tables.hpp"
#include "analyzer/source/budget.hpp"

#include <algorithm>
#include <functional>
#include <limits>
#include <optional>
#include <utility>

namespace maclint::dataflow {
namespace {

/// How many calls of one program, each with other numbers, are followed into what they call.
constexpr std::size_t most_known_calls = 64;
/// Longer programs are not run again for a call: those that only report an error are short.
constexpr std::size_t most_nodes = 2000;

/// How many states of one node are followed back to the caller, before all states are solved together.
constexpr std::size_t most_states_tried = 8;

constexpr std::uint32_t no_way = std::numeric_limits<std::uint32_t>::max();

/// To the block after the call, or to a label of the caller.
bool comes_back_from(const flow::Exit& exit) {
    return exit.kind == flow::ExitKind::returns || exit.kind == flow::ExitKind::runs_off;
}

using IsExit = bool (*)(const flow::Exit& exit);

/// How many edges each node is away from the nearest such exit.
std::vector<std::uint32_t> distances_to(const flow::Graph& graph, IsExit is_exit) {
    std::vector<std::uint32_t> distance(graph.nodes.size(), no_way);
    std::vector<flow::NodeId> exits;
    for (const flow::Exit& exit : graph.exits)
        if (is_exit(exit) && distance[exit.node] != 0) {
            distance[exit.node] = 0;
            exits.push_back(exit.node);
        }
    flow::walk<flow::Direction::backward>(graph, exits, [&](flow::EdgeId id, flow::NodeId from) {
        if (distance[from] != no_way) return flow::Step::refuse;
        distance[from] = distance[graph.edges[id].to] + 1;
        return flow::Step::go_on;
    });
    return distance;
}

/// Whether a path leads to an exit of which the distances are. Every node is tried with a few states, the
/// nearest way first. Nothing where no path does, but nodes would have to be tried with further states.
/// `run(node, State)`: the state after the node, not reached where the path stops there.
template<class Run>
std::optional<bool> leaves_at_first(const flow::Graph& graph, const std::vector<std::uint32_t>& distance,
                                    States& states, Transfer& transfer, const Run& run) {
    std::vector<SmallVector<State, 1>> tried(graph.nodes.size());
    bool all_tried = true;
    std::vector<std::pair<flow::NodeId, State>> ways{{0, states.at_entry()}};
    while (!ways.empty()) {
        const auto [node, before] = ways.back();
        ways.pop_back();
        if (distance[node] == no_way) continue;
        const auto same = [&](const State& other) { return states.equal(other, before); };
        if (std::ranges::any_of(tried[node], same)) continue;
        if (tried[node].size() == most_states_tried) {
            all_tried = false;
            continue;
        }
        tried[node].push_back(before);
        const State after = run(node, before);
        if (!after.reached) continue;
        if (distance[node] == 0) return true;
        const auto first = static_cast<std::ptrdiff_t>(ways.size());
        for (const flow::EdgeId id : graph.out[node])
            if (const State next = transfer.along(graph.edges[id], after); next.reached)
                ways.emplace_back(graph.edges[id].to, next);
        if (ways.end() - ways.begin() > first + 1)
            std::ranges::stable_sort(ways.begin() + first, ways.end(), std::greater{},
                                     [&](const auto& way) { return distance[way.first]; });
    }
    return all_tried ? std::optional(false) : std::nullopt;
}

EntryKnowledge with(EntryKnowledge knowledge, const KnownStart& start) {
    knowledge.known = start.known;
    if (start.arguments) {
        knowledge.arguments = start.arguments;
        knowledge.locals_are_callers = false;
    }
    return knowledge;
}

} // namespace

/// What is known at the call of the variables that decide over the callee's end, and which arguments it
/// passes.
KnownStart Transfer::known_at(const State& state, const Call& call, std::span<const Variable> deciding) {
    const bool shared_frame = program_.control->calls[call.kind].frame == Frame::shared;
    FactLists* const facts = std::exchange(facts_, nullptr); // what is read is recorded already
    KnownStart start;
    const auto know = [&](Variable variable, const Value& value) {
        if (const auto number = value.constant())
            start.known.push_back({variable, number});
        else if (value.vacancy == Vacancy::vacant)
            start.known.push_back({variable, std::nullopt});
    };
    for (const Variable variable : deciding)
        if (shared_frame || program_.control->spaces[variable.space].scope != Scope::frame)
            know(variable, states_.read(state, variable));
    if (!shared_frame) {
        start.arguments.emplace();
        for (const Argument& argument : program_.arguments_of(call)) {
            const auto* letter = std::get_if<Variable>(&argument.given);
            if (letter == nullptr) {
                start.arguments.reset(); // only the workspace knows what it means
                break;
            }
            const Value value = evaluate(state, argument.value, Use::argument);
            start.arguments->emplace_back(*letter, value.vacancy);
            if (std::ranges::find(deciding, *letter) != deciding.end()) know(*letter, value);
        }
    }
    facts_ = facts;
    return start;
}

/// Whether the call can come back with what is known here.
bool Transfer::comes_back(const State& state, const Callee& callee, const Call& call) {
    if (callee.analysis == nullptr || !follows_calls_ || callee.summary.decides_end.empty()) return true;
    KnownStart start = known_at(state, call, callee.summary.decides_end);
    if (start.known.empty()) return true;
    auto& followed = followed_[callee.analysis];
    const auto before = std::ranges::find(followed, start, &FollowedCall::start);
    if (before != followed.end()) return before->comes_back;
    if (followed.size() >= most_known_calls) return true;
    const bool comes_back = callee.analysis->comes_back(start);
    followed.push_back({std::move(start), comes_back});
    return comes_back;
}

bool Analysis::comes_back(const KnownStart& start) const {
    if (graph_->nodes.size() > most_nodes) return true;
    return known_starts_->comes_back(start, [&] {
        const Budget own = Budget::without_bound(); // the answer is kept for others who ask
        return finds_way_back(start);
    });
}

Analysis Analysis::begun_with(const KnownStart& start, FactSet wanted) const {
    return {*program_, *graph_, with(knowledge_, start), callees_, wanted};
}

WaysAround::WaysAround(const Program& program, const flow::Graph& graph, const Analysis& analysis,
                       std::vector<bool> nodes)
    : program_(program)
    , graph_(graph)
    , analysis_(analysis)
    , nodes_(std::move(nodes))
    , distance_(
          distances_to(graph, [](const flow::Exit& exit) { return exit.kind != flow::ExitKind::alarm; })) {}

bool WaysAround::may_leave(const KnownStart& start, const StopsAt& stops) const {
    States states(program_, with(analysis_.knowledge(), start));
    Transfer transfer(program_, graph_, states, analysis_.callees());
    transfer.follow_no_calls();
    FactLists facts;
    facts.record_only(dataflow::facts<CallBegun>());
    const auto run = [&](flow::NodeId node, const State& before) {
        if (!nodes_[node]) return transfer.run(node, before);
        facts.of<CallBegun>().clear();
        transfer.record_in(&facts);
        const State after = transfer.run(node, before);
        transfer.record_in(nullptr);
        return stops(facts.of<CallBegun>()) ? State{} : after;
    };
    return leaves_at_first(graph_, distance_, states, transfer, run).value_or(true);
}

/// Most calls come back, and the first way that is tried shows it. Only where no way does are all looked at.
bool Analysis::finds_way_back(const KnownStart& start) const {
    States states(*program_, with(knowledge_, start));
    Transfer transfer(*program_, *graph_, states, callees_);
    transfer.follow_no_calls();
    const auto run = [&](flow::NodeId node, const State& before) { return transfer.run(node, before); };
    if (const auto known =
            leaves_at_first(*graph_, distances_to(*graph_, comes_back_from), states, transfer, run))
        return *known;
    StateDomain domain(*program_, states, transfer);
    flow::Solution<State> solution;
    flow::solve<flow::Direction::forward>(*graph_, domain, solution);
    return std::ranges::any_of(graph_->exits, [&](const flow::Exit& exit) {
        const State& before = solution.before[exit.node];
        return before.reached && comes_back_from(exit) && transfer.run(exit.node, before).reached;
    });
}

} // namespace maclint::dataflow
