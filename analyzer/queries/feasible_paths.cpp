//! Searches the flow graph for a path around assignments.
#include "analyzer/queries/feasible_paths.hpp"

#include "analyzer/dataflow/cycles.hpp"
#include "analyzer/dataflow/domain/read_set.hpp"
#include "analyzer/dataflow/facts/clobber.hpp"
#include "analyzer/queries/conditions.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace maclint::queries {
namespace {

constexpr std::size_t most_attempts = 12;

/// Sorted, without `except`.
std::vector<flow::NodeId> assigning_nodes(const dataflow::Facts& facts, Variable variable,
                                          flow::NodeId except) {
    std::vector<flow::NodeId> nodes;
    for (const dataflow::Store& store : facts.all<dataflow::Store>())
        if (store.variable == variable && store.node != except) nodes.push_back(store.node);
    return nodes;
}

void add_clobbering_nodes(const dataflow::Facts& facts, Variable variable, flow::NodeId except,
                          std::vector<flow::NodeId>& nodes) {
    for (const dataflow::Clobber& clobber : facts.all<dataflow::Clobber>())
        if (clobber.node != except &&
            (clobber.variable ? *clobber.variable == variable : clobber.space == variable.space))
            nodes.push_back(clobber.node);
    std::ranges::sort(nodes);
}

/// Variables that may hold something else than the path says.
class Unsure {
  public:
    void add(Variable variable) { variables_.push_back(variable); }
    void add(SpaceId space) { spaces_.push_back(space); }
    void remove(Variable variable) { std::erase(variables_, variable); }
    [[nodiscard]] bool holds(Variable variable) const {
        return std::ranges::find(variables_, variable) != variables_.end() ||
               std::ranges::find(spaces_, variable.space) != spaces_.end();
    }
    [[nodiscard]] bool decides(const Program& program, ExpressionId expression) const {
        return std::ranges::any_of(dataflow::variables_of(program, expression).variables,
                                   [this](Variable variable) { return holds(variable); });
    }

  private:
    std::vector<Variable> variables_;
    std::vector<SpaceId> spaces_;
};

/// Why a path is not feasible: this edge is not taken after what stands before it. Where an earlier decision
/// says the opposite, other paths may take the edge.
struct Obstacle {
    flow::EdgeId edge;
    std::optional<flow::EdgeId> opposite;
};

/// Looks for a path that can be gone: each path that cannot is closed at its obstacle.
class FeasiblePathSearch {
  public:
    /// `barred` are the nodes, sorted, that the rounds of a loop must not meet to be left out of a path.
    FeasiblePathSearch(const ProgramAnalysis& analysis, std::span<const flow::NodeId> barred)
        : program_(analysis.program())
        , graph_(analysis.graph())
        , analysis_(analysis.data())
        , barred_(barred) {}

    using FlowPath = std::vector<flow::EdgeId>;
    using Closed = std::vector<flow::EdgeId>;

    /// `find(closed)` gives a path that takes none of the closed edges.
    template<class Find>
    std::optional<FlowPath> run(const Find& find) {
        std::vector<Closed> open{{}};
        for (std::size_t attempt = 0; attempt < most_attempts && !open.empty(); ++attempt) {
            Closed closed = std::move(open.back());
            open.pop_back();
            std::optional<FlowPath> path = find(closed);
            if (!path) continue;
            const auto obstacle = obstacle_on(*path);
            if (!obstacle) return path;
            if (obstacle->opposite) {
                open.push_back(closed);
                open.back().push_back(*obstacle->opposite);
            }
            closed.push_back(obstacle->edge);
            open.push_back(std::move(closed));
        }
        return std::nullopt;
    }

  private:
    [[nodiscard]] std::optional<Obstacle> obstacle_on(const FlowPath& path) {
        const auto contradiction = contradiction_on(path);
        return contradiction ? contradiction : impossible_on(path);
    }

    // ---- decisions ----

    [[nodiscard]] std::span<const dataflow::Store> stores_in(flow::NodeId node) const {
        return analysis_.facts().in<dataflow::Store>(node);
    }

    /// A decision at a place of the path, and the place from which on what it was about may be different.
    struct Decided {
        Decision decision;
        std::size_t at;
        std::size_t until;
    };

    [[nodiscard]] std::optional<Obstacle> contradiction_on(const FlowPath& path) {
        const auto in_a_row = [](std::span<const Decided> all) {
            std::vector<Decision> decisions;
            for (const Decided& decided : all) decisions.push_back(decided.decision);
            return decisions;
        };
        std::vector<Decided> all = decided_on(path);
        if (!first_contradiction(program_, in_a_row(all))) return std::nullopt;
        note_changes(path, all);
        while (const auto found = first_contradiction(program_, in_a_row(all))) {
            const Decided last = all[*found];
            const auto earlier = all.begin() + static_cast<std::ptrdiff_t>(*found);
            const auto valid =
                std::remove_if(all.begin(), earlier, [&](const Decided& d) { return d.until <= last.at; });
            if (valid == earlier) {
                const auto opposite = std::find_if(all.begin(), earlier, [&](const Decided& d) {
                    return first_contradiction(program_, std::array{d.decision, last.decision}).has_value();
                });
                return Obstacle{path[last.at],
                                opposite == earlier ? std::nullopt : std::optional(path[opposite->at])};
            }
            all.erase(valid, earlier);
        }
        return std::nullopt;
    }

    /// The last decisions on the path.
    [[nodiscard]] std::vector<Decided> decided_on(const FlowPath& path) const {
        constexpr std::size_t most_decided = 256;
        std::vector<Decided> all;
        for (std::size_t at = path.size(); at-- > 0 && all.size() < most_decided;) {
            const flow::Edge& edge = graph_.edges[path[at]];
            if (edge.condition) all.push_back({{*edge.condition, edge.holds}, at, path.size()});
        }
        std::ranges::reverse(all);
        return all;
    }

    /// Finds out, from the path's end to its start, until when each decision tells something.
    void note_changes(const FlowPath& path, std::vector<Decided>& all) {
        std::vector<std::pair<Variable, std::size_t>> next_changes; // after the place looked at
        const auto note = [&](flow::NodeId node, std::size_t at) {
            for (const dataflow::Store& store : stores_in(node)) {
                const auto known =
                    std::ranges::find(next_changes, store.variable, &std::pair<Variable, std::size_t>::first);
                if (known == next_changes.end())
                    next_changes.emplace_back(store.variable, at);
                else
                    known->second = at;
            }
        };
        std::size_t at = path.size();
        for (auto decided = all.rbegin(); decided != all.rend(); ++decided) {
            while (--at > decided->at) {
                note(graph_.edges[path[at]].from, at);
                if (ends_rounds(path[at]))
                    for (const flow::NodeId node : rounds_before(path[at])) note(node, at);
            }
            for (const Variable variable :
                 dataflow::variables_of(program_, decided->decision.condition).variables)
                for (const auto& [changed, where] : next_changes)
                    if (changed == variable) decided->until = std::min(decided->until, where);
            ++at; // what is stored in front of this decision is noted for those before it
        }
    }

    // ---- values ----

    /// That a loop is not left before the first round says nothing of the paths after it: the path goes on,
    /// and what the rounds store is not known on it.
    [[nodiscard]] std::optional<Obstacle> impossible_on(FlowPath path) {
        while (const auto edge = analysis_.first_impossible(path)) {
            if (!ends_rounds(*edge)) return Obstacle{*edge, std::nullopt};
            forget_rounds(path, *edge);
        }
        return std::nullopt;
    }

    /// Takes the edge off the path, and all after it that what the rounds store decides.
    void forget_rounds(FlowPath& path, flow::EdgeId edge) {
        Unsure unsure;
        for (const flow::NodeId node : rounds_before(edge)) {
            for (const dataflow::Store& store : stores_in(node)) unsure.add(store.variable);
            for (const dataflow::Clobber& change : analysis_.facts().in<dataflow::Clobber>(node))
                if (change.variable)
                    unsure.add(*change.variable);
                else
                    unsure.add(change.space);
        }
        const auto after = path.erase(std::ranges::find(path, edge));
        const auto kept = std::remove_if(after, path.end(), [&](flow::EdgeId id) {
            const flow::Edge& next = graph_.edges[id];
            for (const dataflow::Store& store : stores_in(next.from)) {
                if (unsure.decides(program_, store.expression))
                    unsure.add(store.variable);
                else
                    unsure.remove(store.variable);
            }
            if (next.condition) return unsure.decides(program_, *next.condition);
            const auto* jump = next.label ? std::get_if<Jump>(&program_.effects[*next.jump].what) : nullptr;
            return jump != nullptr && unsure.decides(program_, jump->target);
        });
        path.erase(kept, path.end());
    }

    // ---- rounds ----

    /// The edge leaves a loop, none of whose rounds meets a barred node.
    [[nodiscard]] bool ends_rounds(flow::EdgeId id) {
        const flow::Edge& edge = graph_.edges[id];
        const auto rounds = rounds_before(id);
        if (rounds.size() < 2 || components_->of[edge.from] == components_->of[edge.to]) return false;
        return std::ranges::none_of(
            rounds, [this](flow::NodeId node) { return std::ranges::binary_search(barred_, node); });
    }

    /// The nodes from which who stands before the edge can come back there.
    [[nodiscard]] std::span<const flow::NodeId> rounds_before(flow::EdgeId id) {
        if (!components_) components_ = flow::find_components(dataflow::adjacency_along(graph_, analysis_));
        return components_->members[components_->of[graph_.edges[id].from]];
    }

    const Program& program_;
    const flow::Graph& graph_;
    const dataflow::Analysis& analysis_;
    std::span<const flow::NodeId> barred_;
    std::optional<flow::Components> components_; ///< of the passable edges, once somebody has asked
};

/// A search of everything: what it does not find is not there.
std::size_t whole(const flow::Graph& graph) { return graph.nodes.size() + 1; }

} // namespace

bool assigned_on_every_path(const ProgramAnalysis& analysis, Variable variable, flow::NodeId node) {
    const flow::Graph& graph = analysis.graph();
    const std::vector<flow::NodeId> assigning = assigning_nodes(analysis.facts(), variable, node);
    const auto assigns = [&](flow::NodeId n) { return std::ranges::binary_search(assigning, n); };
    if (assigning.empty() || node == 0) return false;
    if (assigns(0)) return true;
    const auto usable = [&](flow::EdgeId edge) {
        return analysis.data().passable(edge) && !assigns(graph.edges[edge].to);
    };
    return !graph.path(0, node, usable, whole(graph));
}

std::vector<const dataflow::Store*> last_stores_before(const ProgramAnalysis& analysis, Variable variable,
                                                       const dataflow::Loop& loop) {
    const flow::Graph& graph = analysis.graph();
    const auto& all = analysis.facts().all<dataflow::Store>();
    std::vector<const dataflow::Store*> found;
    std::vector<bool> seen(graph.nodes.size(), false);
    std::vector<flow::NodeId> pending{loop.head};
    while (!pending.empty()) {
        const flow::NodeId node = pending.back();
        pending.pop_back();
        for (const flow::EdgeId edge : graph.in[node]) {
            const flow::NodeId from = graph.edges[edge].from;
            if (seen[from] || loop.holds(from) || !analysis.data().passable(edge)) continue;
            seen[from] = true;
            const dataflow::Store* last = nullptr;
            for (auto store = std::ranges::lower_bound(all, from, {}, &dataflow::Store::node);
                 store != all.end() && store->node == from; ++store)
                if (store->variable == variable) last = &*store;
            if (last != nullptr)
                found.push_back(last);
            else
                pending.push_back(from);
        }
    }
    return found;
}

std::optional<std::vector<flow::EdgeId>> path_without_assignment(const ProgramAnalysis& analysis,
                                                                 Variable variable, flow::NodeId node) {
    const flow::Graph& graph = analysis.graph();
    std::vector<flow::NodeId> assigning = assigning_nodes(analysis.facts(), variable, node);
    add_clobbering_nodes(analysis.facts(), variable, node, assigning);
    if (node == 0) return std::vector<flow::EdgeId>{};
    if (std::ranges::binary_search(assigning, flow::NodeId{0})) return std::nullopt;
    return FeasiblePathSearch(analysis, assigning).run([&](const FeasiblePathSearch::Closed& closed) {
        const auto usable = [&](flow::EdgeId edge) {
            return analysis.data().passable(edge) &&
                   !std::ranges::binary_search(assigning, graph.edges[edge].to) &&
                   std::ranges::find(closed, edge) == closed.end();
        };
        return graph.path(0, node, usable, whole(graph));
    });
}

bool can_follow(const ProgramAnalysis& analysis, flow::NodeId first, flow::NodeId then,
                std::span<const flow::NodeId> barred) {
    const flow::Graph& graph = analysis.graph();
    const auto find =
        [&](const FeasiblePathSearch::Closed& closed) -> std::optional<FeasiblePathSearch::FlowPath> {
        const auto possible = [&](flow::EdgeId edge) {
            return analysis.data().passable(edge) && std::ranges::find(closed, edge) == closed.end();
        };
        const auto past = [&](flow::EdgeId edge) {
            const flow::NodeId next = graph.edges[edge].to;
            return possible(edge) && (next == then || !std::ranges::binary_search(barred, next));
        };
        using FlowPath = std::optional<FeasiblePathSearch::FlowPath>;
        FlowPath path = first == 0 ? FlowPath(std::in_place) : graph.path(0, first, possible, whole(graph));
        const FlowPath rest =
            first == then ? FlowPath(std::in_place) : graph.path(first, then, past, whole(graph));
        if (!path || !rest) return std::nullopt;
        path->insert(path->end(), rest->begin(), rest->end());
        return path;
    };
    return FeasiblePathSearch(analysis, barred).run(find).has_value();
}

} // namespace maclint::queries
