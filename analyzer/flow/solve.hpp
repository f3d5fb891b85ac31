//! Calculates something along all paths of a graph, forwards or backwards, until nothing changes: control
//! flow apart from what is calculated.
#pragma once

#include "analyzer/flow/components.hpp"
#include "analyzer/flow/graph.hpp"
#include "analyzer/flow/worklist.hpp"

#include <algorithm>
#include <concepts>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace maclint::flow {

enum class Direction : std::uint8_t { forward, backward };

/// What is calculated. A `State{}` says that no path has come so far; "in front of" and "after" are meant in
/// the direction of the calculation.
template<class D>
concept Domain = requires(D domain, NodeId node, const Edge& edge, const typename D::State& state) {
    /// The state in front of a node at which paths begin, for others State{}.
    { domain.at_begin(node) } -> std::same_as<typename D::State>;
    { domain.is_reached(state) } -> std::same_as<bool>;
    { domain.equal(state, state) } -> std::same_as<bool>;
    /// All that either says; `node` is where the paths meet.
    { domain.join(state, state, node) } -> std::same_as<typename D::State>;
    /// The state after the node.
    { domain.run(node, state) } -> std::same_as<typename D::State>;
    /// The state at the end of an edge of the node that was run last, given the state after it.
    { domain.along(edge, state) } -> std::same_as<typename D::State>;
};

/// A domain whose states could go on changing for long, as bounds of numbers do: from some visit of a node on
/// it takes more than the paths say.
template<class D>
concept Widening = Domain<D> &&
    requires(D domain, NodeId node, bool is_head, std::uint32_t visit, const typename D::State& state) {
    /// Whether it does so at visit `visit` (from 0) of a node; in every cycle one node is a head.
    { domain.widens(is_head, visit) } -> std::same_as<bool>;
    /// What is taken in place of `incoming`, where `old` was the state.
    { domain.widen(node, is_head, visit, state, state) } -> std::same_as<typename D::State>;
};

/// A domain of sets that grow: the state at the end of an edge is the one behind its node, and what meets at
/// a node is added to one set there, so that no edge needs a state of its own.
template<class D>
concept Gathering = requires(const D domain, NodeId node, typename D::State& set,
                             const typename D::State& more) {
    /// As of any domain.
    { domain.at_begin(node) } -> std::same_as<typename D::State>;
    { domain.is_reached(more) } -> std::same_as<bool>;
    /// Adds to the set, which may be State{}; whether it has grown.
    { domain.add(set, more) } -> std::same_as<bool>;
    /// From the state in front of the node to the one behind it.
    { domain.run(node, set) } -> std::same_as<void>;
};

/// A gathering domain that knows of edges that no path leads over.
template<class D>
concept Refusing = Gathering<D> && requires(const D domain, EdgeId edge) {
    { domain.is_passable(edge) } -> std::same_as<bool>;
};

/// A domain that wants to know of every node when the state in front of it changes no more.
template<class D>
concept Settling = Domain<D> && requires(D domain, NodeId node, const typename D::State& state) {
    /// The state after the node, as `run` says; asked once of each node that is reached, of a node that
    /// follows another after that one.
    { domain.run_settled(node, state) } -> std::same_as<typename D::State>;
};

/// The states of a solution, and the memory for the next one.
template<class State>
struct Solution {
    std::vector<State> before;         ///< in front of every node
    std::vector<State> along;          ///< at the end of every edge
    std::vector<std::uint32_t> visits; ///< of every node
};

/// A graph as it is walked in the direction.
template<Direction direction>
class Walked {
  public:
    explicit Walked(const Graph& graph)
        : graph_(graph) {}

  protected:
    [[nodiscard]] NodeId size() const { return static_cast<NodeId>(graph_.nodes.size()); }
    [[nodiscard]] std::span<const EdgeId> edges_to(NodeId node) const {
        return forward ? graph_.in[node] : graph_.out[node];
    }
    [[nodiscard]] std::span<const EdgeId> edges_from(NodeId node) const {
        return forward ? graph_.out[node] : graph_.in[node];
    }
    [[nodiscard]] static NodeId target(const Edge& edge) { return forward ? edge.to : edge.from; }
    /// Nodes are visited in the order of the text, or against it.
    [[nodiscard]] NodeId in_turn(NodeId node) const { return forward ? node : size() - 1 - node; }

    const Graph& graph_;

  private:
    static constexpr bool forward = direction == Direction::forward;
};

/// Solves one loop after the other: what follows a loop is not looked at before the loop has settled.
template<Domain D, Direction direction>
class Solver : Walked<direction> {
  public:
    using State = typename D::State;

    Solver(const Graph& graph, D& domain, Solution<State>& solution)
        : Walked<direction>(graph)
        , domain_(domain)
        , before_(solution.before)
        , along_(solution.along)
        , visits_(solution.visits) {
        before_.assign(graph.nodes.size(), {});
        along_.assign(graph.edges.size(), {});
        visits_.assign(graph.nodes.size(), 0);
    }

    void run() {
        collect_heads();
        if (leads_back_)
            run_components();
        else
            for (NodeId turn = 0; turn < size(); ++turn) pass(in_turn(turn));
    }

  private:
    using Walked<direction>::graph_, Walked<direction>::size, Walked<direction>::edges_to,
        Walked<direction>::edges_from, Walked<direction>::target, Walked<direction>::in_turn;

    static constexpr std::size_t most_in_a_row = 32;

    /// In every cycle an edge leads back in the text.
    void collect_heads() {
        head_.assign(graph_.nodes.size(), false);
        for (const Edge& edge : graph_.edges)
            if (edge.to <= edge.from) head_[target(edge)] = leads_back_ = true;
    }

    void run_components() {
        Adjacency adjacency;
        adjacency.reserve(graph_.nodes.size(), graph_.edges.size());
        for (NodeId node = 0; node < graph_.nodes.size(); ++node) {
            for (const EdgeId edge : edges_from(node)) adjacency.add(target(graph_.edges[edge]));
            adjacency.end_list();
        }
        components_ = find_components(adjacency);
        place_.resize(graph_.nodes.size());
        for (std::size_t each = components_.members.size(); each-- > 0;) {
            const auto members = components_.members[each];
            const auto follow = adjacency[members.front()];
            if (members.size() > 1 || std::ranges::find(follow, members.front()) != follow.end())
                settle(members);
            else
                pass(members.front());
        }
    }

    /// A node that no path comes to twice; all in front of it have settled.
    void pass(NodeId node) {
        const auto in = edges_to(node);
        State begin = domain_.at_begin(node);
        if (in.size() == 1 && !domain_.is_reached(begin))
            before_[node] = along_[in.front()];
        else
            before_[node] = incoming(node, std::move(begin));
        if (!domain_.is_reached(before_[node])) return;
        const State after = run_settled(node);
        for (const EdgeId edge : edges_from(node)) along_[edge] = domain_.along(graph_.edges[edge], after);
    }

    /// Nodes that lead to each other, in text order; what leads to them from elsewhere has settled.
    void settle(std::span<const NodeId> members) {
        const auto count = static_cast<NodeId>(members.size());
        const auto at = [&](NodeId turn) {
            return members[direction == Direction::forward ? turn : count - 1 - turn];
        };
        for (NodeId turn = 0; turn < count; ++turn) place_[at(turn)] = turn;
        Worklist waiting(count);
        const std::uint32_t component = components_.of[members.front()];
        const auto add = [&](NodeId node) {
            if (components_.of[node] == component) waiting.add(place_[node]);
        };
        for (const NodeId node : members)
            if (is_led_to(node)) add(node);
        while (const auto next = waiting.take()) {
            const NodeId node = at(*next);
            const std::uint32_t visit = visits_[node]++;
            if (update(node, visit) && domain_.is_reached(before_[node])) propagate(node, add);
        }
        if constexpr (Widening<D>) narrow(count, at, component);
        if constexpr (Settling<D>)
            for (NodeId turn = 0; turn < count; ++turn)
                if (domain_.is_reached(before_[at(turn)])) (void)run_settled(at(turn));
    }

    [[nodiscard]] bool is_led_to(NodeId node) {
        return domain_.is_reached(domain_.at_begin(node)) ||
               std::ranges::any_of(edges_to(node),
                                   [&](EdgeId edge) { return domain_.is_reached(along_[edge]); });
    }

    [[nodiscard]] State run_settled(NodeId node) {
        if constexpr (Settling<D>)
            return domain_.run_settled(node, before_[node]);
        else
            return domain_.run(node, before_[node]);
    }

    /// All paths that lead to the node, and those that begin there.
    [[nodiscard]] State incoming(NodeId node, State begin) {
        const auto in = edges_to(node);
        return in.size() <= most_in_a_row ? joined(std::move(begin), in, node)
                                          : domain_.join(begin, in_halves(in, node), node);
    }
    [[nodiscard]] State joined(State state, std::span<const EdgeId> edges, NodeId node) {
        for (const EdgeId edge : edges) state = domain_.join(std::move(state), along_[edge], node);
        return state;
    }
    /// What one edge says that no other does is not looked at again for each that follows.
    [[nodiscard]] State in_halves(std::span<const EdgeId> edges, NodeId node) {
        if (edges.size() <= most_in_a_row) return joined({}, edges, node);
        const auto half = edges.size() / 2;
        return domain_.join(in_halves(edges.first(half), node), in_halves(edges.subspan(half), node), node);
    }

    /// Whether the state in front of the node has changed.
    bool update(NodeId node, std::uint32_t visit) {
        State& old = before_[node];
        const auto in = edges_to(node);
        State begin = domain_.at_begin(node);
        if (in.size() == 1 && !head_[node] && !domain_.is_reached(begin)) {
            // It comes here because that edge has changed.
            old = along_[in.front()];
            return true;
        }
        State state = incoming(node, std::move(begin));
        if (domain_.is_reached(old)) {
            if constexpr (Widening<D>)
                if (domain_.widens(head_[node], visit))
                    state = domain_.widen(node, head_[node], visit, old, state);
            if (domain_.equal(state, old)) return false;
        }
        old = std::move(state);
        return true;
    }

    template<class Add>
    void propagate(NodeId node, const Add& add) {
        const State after = domain_.run(node, before_[node]);
        for (const EdgeId edge : edges_from(node)) {
            State next = domain_.along(graph_.edges[edge], after);
            if (domain_.equal(next, along_[edge])) continue;
            along_[edge] = std::move(next);
            add(target(graph_.edges[edge]));
        }
    }

    /// One sweep without widening wins back what widening gave away; a solution stays a solution. Only what
    /// was widened, and what follows from it, can change.
    template<class At>
    void narrow(NodeId count, const At& at, std::uint32_t component) requires Widening<D> {
        std::vector<bool> may_change(count, false);
        bool any = false;
        for (NodeId turn = 0; turn < count; ++turn) {
            const NodeId node = at(turn);
            may_change[turn] = visits_[node] > 0 && domain_.widens(head_[node], visits_[node] - 1);
            any = any || may_change[turn];
        }
        if (!any) return;
        for (NodeId turn = 0; turn < count; ++turn) {
            const NodeId node = at(turn);
            if (!may_change[turn] || !domain_.is_reached(before_[node])) continue;
            State state = incoming(node, domain_.at_begin(node));
            if (domain_.equal(state, before_[node])) continue;
            before_[node] = std::move(state);
            propagate(node, [&](NodeId next) {
                if (components_.of[next] == component) may_change[place_[next]] = true;
            });
        }
    }

    D& domain_;
    std::vector<State>& before_;
    std::vector<State>& along_;
    std::vector<std::uint32_t>& visits_;
    std::vector<bool> head_;
    bool leads_back_ = false;   ///< an edge does, in the text
    Components components_;     ///< of the graph in the direction; only where an edge leads back
    std::vector<NodeId> place_; ///< of a node among those of its component
};

template<Gathering D, Direction direction>
class Gatherer : Walked<direction> {
  public:
    using State = typename D::State;

    Gatherer(const Graph& graph, const D& domain)
        : Walked<direction>(graph)
        , domain_(domain) {}

    [[nodiscard]] std::vector<State> run() {
        std::vector<State> before(size());
        Worklist waiting(size());
        for (NodeId node = 0; node < size(); ++node) {
            before[node] = domain_.at_begin(node);
            if (domain_.is_reached(before[node])) waiting.add(in_turn(node));
        }
        State state;
        while (const auto next = waiting.take()) {
            const NodeId node = in_turn(*next);
            state = before[node];
            domain_.run(node, state);
            for (const EdgeId edge : edges_from(node))
                if (const NodeId to = target(graph_.edges[edge]);
                    is_passable(edge) && domain_.add(before[to], state))
                    waiting.add(in_turn(to));
        }
        return before;
    }

  private:
    using Walked<direction>::graph_, Walked<direction>::size, Walked<direction>::edges_from,
        Walked<direction>::target, Walked<direction>::in_turn;

    [[nodiscard]] bool is_passable(EdgeId edge) const {
        if constexpr (Refusing<D>)
            return domain_.is_passable(edge);
        else
            return true;
    }

    const D& domain_;
};

/// The smallest states in front of every node that all paths of the graph allow.
template<Direction direction, Gathering D>
[[nodiscard]] std::vector<typename D::State> solve(const Graph& graph, const D& domain) {
    return Gatherer<D, direction>(graph, domain).run();
}

/// Fills `solution` with the smallest states that all paths of the graph allow, or with larger ones where the
/// domain widens.
template<Direction direction, Domain D>
void solve(const Graph& graph, D& domain, Solution<typename D::State>& solution) {
    Solver<D, direction>(graph, domain, solution).run();
}

} // namespace maclint::flow
