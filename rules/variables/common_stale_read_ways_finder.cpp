//! Holds the ways against each other that meet in one block.
#include "rules/variables/common_stale_read_ways_finder.hpp"

#include "analyzer/dataflow/domain/read_set.hpp"
#include "analyzer/dataflow/domain/state.hpp"
#include "analyzer/execution/path_search.hpp"
#include "analyzer/flow/walk.hpp"
#include "analyzer/program/tables.hpp"
#include "analyzer/queries/conditions/conditions.hpp"
#include "analyzer/source/budget.hpp"
#include "rules/variables/common_stale_read_cases_finder.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <unordered_set>
#include <utility>
#include <variant>

namespace maclint::rules {
namespace {

using dataflow::Store;

constexpr std::size_t most_blocks = 16; ///< of one way, from the condition on

/// Blocks in a row behind one side of a condition, up to where other ways come in.
struct Way {
    ExpressionId condition;
    flow::NodeId begin; ///< the condition's own
    flow::NodeId end;
    std::vector<const Store*> stores;

    [[nodiscard]] const Store* store_in(Variable variable) const {
        const auto found =
            std::ranges::find(stores, variable, [](const Store* store) { return store->variable; });
        return found == stores.end() ? nullptr : *found;
    }
};

class Ways {
  public:
    explicit Ways(const ProgramAnalysis& analysis)
        : analysis_(analysis)
        , graph_(analysis.graph()) {
        for (flow::EdgeId id = 0; id < graph_.edges.size(); ++id)
            if (graph_.edges[id].condition && analysis.data().passable(id)) add(graph_.edges[id]);
    }

    std::optional<OneWaySet> of(Variable variable) {
        std::vector<flow::NodeId> setting;
        std::vector<bool> unset_at; // where it may be as it was; asked for where there is a sibling
        for (const Way& way : ways_) {
            const Store* store = way.store_in(variable);
            if (store == nullptr || asks_for(way, variable)) continue;
            for (const Way& other : ways_) {
                if (!Budget::allows()) return std::nullopt;
                const Store* sibling = sibling_of(way, other, variable);
                if (sibling == nullptr) continue;
                if (unset_at.empty()) {
                    setting = nodes_that_set(analysis_, variable);
                    unset_at = reached_from(0, setting);
                }
                if (!unset_at[sibling->node]) continue;
                if (auto found = read_behind(sibling->node, variable, setting)) {
                    found->store = store;
                    found->sibling = sibling;
                    found->condition = way.condition;
                    return found;
                }
            }
            if (!Budget::allows()) return std::nullopt;
            if (auto found = of_passed_by(way, *store)) return found;
        }
        return std::nullopt;
    }

  private:
    void add(const flow::Edge& edge) {
        Way way{*edge.condition, edge.from, edge.to, {}};
        for (std::size_t i = 0; i < most_blocks; ++i) {
            if (graph_.in[way.end].size() != 1) {
                (way.stores.empty() ? ways_without_stores_ : ways_).push_back(std::move(way));
                return;
            }
            for (const Store& store : analysis_.facts().in<Store>(way.end)) way.stores.push_back(&store);
            if (graph_.out[way.end].size() != 1) return;
            way.end = graph_.edges[graph_.out[way.end].front()].to;
        }
    }

    [[nodiscard]] bool asks_for(const Way& way, Variable variable) const {
        const auto asked = dataflow::variables_of(analysis_.program(), way.condition).variables;
        return std::ranges::find(asked, variable) != asked.end();
    }

    /// A store of the other way in a variable that both set; nullptr: there is none, they do not meet where
    /// they end, or the other way sets the variable that is asked about, or depends on it.
    [[nodiscard]] const Store* sibling_of(const Way& way, const Way& other, Variable asked) const {
        if (way.end != other.end || other.store_in(asked) != nullptr || asks_for(other, asked))
            return nullptr;
        const auto found = std::ranges::find_if(
            other.stores, [&](const Store* store) { return way.store_in(store->variable) != nullptr; });
        return found == other.stores.end() ? nullptr : *found;
    }

    /// Of the only store, which the condition passes by where a letter is left out, and which calculates with
    /// that letter. What copies it keeps the last one that was given, and may mean to.
    [[nodiscard]] std::optional<OneWaySet> of_passed_by(const Way& way, const Store& store) {
        const bool is_passed_by = std::ranges::any_of(ways_without_stores_, [&](const Way& other) {
            return other.begin == way.begin && other.end == way.end;
        });
        if (!is_passed_by || !calculates_with_what_is_asked(way, store)) return std::nullopt;
        const auto setting = nodes_that_set(analysis_, store.variable);
        if (setting.size() != 1 || !reached_from(0, setting)[way.end]) return std::nullopt;
        auto found = read_behind(way.end, store.variable, setting);
        if (found) {
            found->store = &store;
            found->condition = way.condition;
        }
        return found;
    }

    [[nodiscard]] bool calculates_with_what_is_asked(const Way& way, const Store& store) const {
        const Program& program = analysis_.program();
        const auto* assign = std::get_if<Assign>(&program.effects[store.effect].what);
        if (assign == nullptr || !std::holds_alternative<Apply>(program.expressions[assign->value].node))
            return false;
        if (!queries::tests_any_vacancy(program, way.condition)) return false;
        const auto read = dataflow::variables_of(program, assign->value).variables;
        return std::ranges::any_of(read, [&](Variable variable) { return asks_for(way, variable); });
    }

    /// From the node on, by which it is not set.
    [[nodiscard]] std::optional<OneWaySet> read_behind(flow::NodeId node, Variable variable,
                                                       std::span<const flow::NodeId> setting) {
        const std::vector<bool> behind = reached_from(node, setting);
        for (const dataflow::Read* read : first_reads(analysis_, variable)) {
            if (!behind[read->node]) continue;
            const std::array legs = {execution::Leg{node, setting}, execution::Leg{read->node, setting}};
            auto found = search_.find(std::span(legs).first(read->node == node ? 1 : 2));
            if (found.path) return OneWaySet{read, nullptr, nullptr, 0, *std::move(found.path)};
        }
        return std::nullopt;
    }

    /// Nodes to which edges lead around those that set the variable, whatever decides them.
    [[nodiscard]] std::vector<bool> reached_from(flow::NodeId start,
                                                 std::span<const flow::NodeId> setting) const {
        std::vector<bool> reached(graph_.nodes.size(), false);
        reached[start] = true;
        flow::walk<flow::Direction::forward>(graph_, {start}, [&](flow::EdgeId edge, flow::NodeId to) {
            if (!analysis_.data().passable(edge)) return flow::Step::refuse;
            reached[to] = true;
            return std::ranges::binary_search(setting, to) ? flow::Step::end : flow::Step::go_on;
        });
        return reached;
    }

    const ProgramAnalysis& analysis_;
    const flow::Graph& graph_;
    execution::PathSearch search_{analysis_};
    std::vector<Way> ways_, ways_without_stores_;
};

} // namespace

std::vector<OneWaySet> find_reads_behind_one_way(const ProgramAnalysis& analysis) {
    std::vector<OneWaySet> found;
    std::unordered_set<dataflow::Key> seen;
    std::optional<Ways> ways;
    for (const Store& store : analysis.facts().all<Store>()) {
        if (analysis.control().spaces[store.variable.space].scope != Scope::shared ||
            !seen.insert(dataflow::key_of(store.variable)).second)
            continue;
        if (!ways) ways.emplace(analysis);
        auto one = ways->of(store.variable);
        if (one && !callers_set(analysis, store.variable)) found.push_back(*std::move(one));
    }
    return found;
}

} // namespace maclint::rules
