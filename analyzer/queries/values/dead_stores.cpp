//! Asks liveness, and looks where the program goes on to.
#include "analyzer/queries/values/dead_stores.hpp"

#include "analyzer/dataflow/domain/read_set.hpp"
#include "analyzer/dataflow/domain/state.hpp"
#include "analyzer/flow/walk.hpp"
#include "analyzer/program/tables.hpp"
#include "analyzer/source/budget.hpp"

#include <algorithm>
#include <set>
#include <unordered_set>
#include <utility>

namespace maclint::queries {
namespace {

constexpr int most_blocks = 64; ///< from a condition to a store that it decides

/// Nodes that are looked at behind all stores of a program, and those that each store adds to them.
constexpr std::size_t most_nodes = 1'000'000;
constexpr std::size_t nodes_of_a_store = 1000;

bool only_calculates(const Effect& effect) {
    return std::holds_alternative<Assign>(effect.what) || std::holds_alternative<Guarded>(effect.what) ||
           std::holds_alternative<Jump>(effect.what) || std::holds_alternative<RegionMark>(effect.what);
}

/// The variables that the program reads, asked once.
class Reads {
  public:
    explicit Reads(const ProgramAnalysis& analysis) {
        for (const dataflow::Read& read : analysis.facts().all<dataflow::Read>())
            read_.insert(dataflow::key_of(read.variable));
    }
    [[nodiscard]] bool hold(Variable variable) const { return read_.contains(dataflow::key_of(variable)); }

  private:
    std::unordered_set<dataflow::Key> read_;
};

/// Looks from one store on.
class FateOfStore {
  public:
    FateOfStore(const ProgramAnalysis& analysis, const dataflow::Store& store)
        : analysis_(analysis)
        , graph_(analysis.graph())
        , store_(store)
        , found_{&store, {}, false, false, false, false, {}} {
        const VariableSpace& space = analysis.control().spaces[store.variable.space];
        own_ = space.scope == Scope::frame && !space.handed_down;
        found_.read_elsewhere = !own_;
        if (const auto* load = std::get_if<Load>(&analysis.program().expressions[store.expression].node))
            source_ = load->variable;
    }

    /// Nothing where somebody else may read the variable before.
    std::optional<DeadStore> run() {
        const auto read = dataflow::variables_of(analysis_.program(), store_.expression);
        found_.is_setting = read.closed && read.variables.empty();
        if (const dataflow::Store* next = store_in(store_.node, store_.effect + 1))
            found_.replaced_by.push_back(next);
        else
            go_on();
        if (is_left_out()) return std::nullopt;
        // A loop that nothing ends has rules of its own.
        if (found_.replaced_by.empty() && !found_.may_end) return std::nullopt;
        std::ranges::sort(found_.replaced_by, {}, &dataflow::Store::effect);
        if (found_.replaced_by.size() == 1 && !found_.may_end)
            found_.only_if = deciding_condition(found_.replaced_by.front()->node);
        if (is_left_out()) return std::nullopt;
        return std::move(found_);
    }

  private:
    /// Whether nothing is told, whatever comes.
    [[nodiscard]] bool is_left_out() const { return left_out_ || (!own_ && found_.may_end); }

    void go_on() {
        pass(store_.node);
        flow::walk<flow::Direction::forward>(graph_, {store_.node},
                                             [&](flow::EdgeId edge, flow::NodeId node) {
                                                 if (!analysis_.data().passable(edge) || is_left_out())
                                                     return flow::Step::refuse;
                                                 if (const dataflow::Store* next = store_in(node, 0)) {
                                                     found_.replaced_by.push_back(next);
                                                     return flow::Step::end;
                                                 }
                                                 pass(node);
                                                 return flow::Step::go_on;
                                             });
    }

    void pass(flow::NodeId node) {
        const flow::Node& at = graph_.nodes[node];
        const bool calculates =
            !at.is_run && std::ranges::all_of(analysis_.program().effects_in(at.effects), only_calculates);
        left_out_ |= !own_ && !calculates;
        found_.may_end |= !graph_.exits_at(node).empty();
    }

    /// The store in the node that replaces the value; notes what is set there before.
    [[nodiscard]] const dataflow::Store* store_in(flow::NodeId node, EffectId from) {
        for (const dataflow::Store& store : analysis_.facts().in<dataflow::Store>(node)) {
            if (store.effect < from) continue;
            if (store.variable == store_.variable) return &store;
            found_.source_changes |= store.variable == source_;
        }
        return nullptr;
    }

    /// The nearest condition of an IF in front of the store whose other outcome leads to `next` as well.
    [[nodiscard]] std::optional<ExpressionId> deciding_condition(flow::NodeId next) {
        flow::NodeId node = store_.node;
        for (int i = 0; i < most_blocks; ++i) {
            const auto in = graph_.in[node];
            if (in.size() != 1) return std::nullopt;
            const flow::Edge& edge = graph_.edges[in.front()];
            if (edge.condition && leads_around(edge, next)) {
                left_out_ |=
                    is_part_of(edge.from, [](RegionKind kind) { return kind == RegionKind::selection; });
                if (!is_part_of(edge.from, is_loop)) return edge.condition;
            }
            if (!edge.condition && edge.kind != flow::EdgeKind::next) return std::nullopt;
            node = edge.from;
        }
        return std::nullopt;
    }

    /// Whether the node belongs to a construct of that kind.
    [[nodiscard]] bool is_part_of(flow::NodeId node, bool (*wanted)(RegionKind)) const {
        return std::ranges::any_of(analysis_.program().effects_in(graph_.nodes[node].effects),
                                   [&](const Effect& effect) {
                                       const auto* mark = std::get_if<RegionMark>(&effect.what);
                                       return mark != nullptr && wanted(mark->region_kind);
                                   });
    }

    /// Whether the other outcome of the decision leads to the node.
    [[nodiscard]] bool leads_around(const flow::Edge& taken, flow::NodeId to) const {
        bool leads = false;
        flow::walk<flow::Direction::forward>(graph_, {taken.from}, [&](flow::EdgeId id, flow::NodeId node) {
            const flow::Edge& edge = graph_.edges[id];
            const bool same_way = edge.from == taken.from && edge.to == taken.to;
            if (same_way || !analysis_.data().passable(id)) return flow::Step::refuse;
            leads |= node == to;
            return node == to || node == taken.from ? flow::Step::end : flow::Step::go_on;
        });
        return leads;
    }

    const ProgramAnalysis& analysis_;
    const flow::Graph& graph_;
    const dataflow::Store& store_;
    DeadStore found_;
    std::optional<Variable> source_; ///< that is copied
    bool own_;                       ///< no other program sees the variable
    bool left_out_ = false;
};

bool saves_modal_code(const Program& program, const dataflow::Store& store) {
    return std::holds_alternative<LoadModal>(program.expressions[store.expression].node);
}

} // namespace

std::vector<DeadStore> find_dead_stores(const ProgramAnalysis& analysis) {
    std::vector<DeadStore> dead;
    const auto& stores = analysis.facts().all<dataflow::Store>();
    if (stores.empty()) return dead;
    if (!analysis.liveness().is_known()) {
        analysis.search_memory().count(true);
        return dead;
    }
    std::optional<Reads> reads; // most programs have no dead store
    const Budget budget(most_nodes + nodes_of_a_store * stores.size());
    for (const dataflow::Store& store : stores) {
        if (saves_modal_code(analysis.program(), store) ||
            analysis.liveness().is_live_after(store.effect, store.variable))
            continue;
        if (!reads) reads.emplace(analysis);
        auto found = FateOfStore(analysis, store).run();
        if (budget.is_spent()) {
            analysis.search_memory().count(true);
            break;
        }
        if (!found) continue;
        found->read_elsewhere |= reads->hold(store.variable);
        dead.push_back(*std::move(found));
    }
    return dead;
}

} // namespace maclint::queries
