//! Natural loops of the reached part of the flow graph.
#include "analyzer/dataflow/loops.hpp"

#include "analyzer/program/overloaded.hpp"

#include <algorithm>
#include <tuple>
#include <unordered_map>

namespace maclint::dataflow {
namespace {

/// Nodes looked at for all loops of a program together, per node of the program; keeps the search linear.
constexpr std::size_t work_per_node = 16;
constexpr std::size_t work_at_least = 20'000;

/// Facts are in the order of nodes, and so is the body: each node's are looked up behind those of the last.
template<class Fact, class Visit>
void for_each_in_body(const Loop& loop, const std::vector<Fact>& facts, const Visit& visit) {
    auto fact = facts.begin();
    for (const flow::NodeId node : loop.body) {
        fact = std::ranges::lower_bound(fact, facts.end(), node, {}, &Fact::node);
        for (; fact != facts.end() && fact->node == node; ++fact) visit(*fact);
        if (fact == facts.end()) return;
    }
}

class LoopSearch {
  public:
    LoopSearch(const Program& program, const flow::Structures& structures, const flow::Graph& graph,
               const Analysis& analysis)
        : program_(program)
        , graph_(graph)
        , analysis_(analysis)
        , budget_(std::max(work_at_least, work_per_node * graph.nodes.size()))
        , mark_(graph.nodes.size(), 0) {
        for (flow::StructureId id = 0; id < structures.all.size(); ++id)
            by_open_.emplace(structures.all[id].open, id);
        for (const flow::Exit& exit : graph.exits) exits_.push_back(exit.node);
        std::ranges::sort(exits_);
    }

    std::vector<Loop> run() {
        std::vector<Loop> loops;
        for (flow::EdgeId edge = 0; edge < graph_.edges.size(); ++edge) {
            if (!is_back(edge)) continue;
            Loop loop = loop_of(edge);
            if (budget_ == 0) break; // its body is not complete
            loops.push_back(std::move(loop));
        }
        std::ranges::sort(loops, {}, [this](const Loop& loop) {
            return std::tuple(graph_.nodes[loop.head].part.begin, loop.head,
                              graph_.nodes[loop.latch].part.begin, loop.back);
        });
        return loops;
    }

  private:
    [[nodiscard]] bool is_back(flow::EdgeId id) const {
        const flow::Edge& edge = graph_.edges[id];
        return analysis_.passable(id) && graph_.order[edge.to] <= graph_.order[edge.from];
    }

    Loop loop_of(flow::EdgeId back) {
        const flow::Edge& edge = graph_.edges[back];
        Loop loop{edge.to, edge.from, back, {}, {}, {}, false, false};
        collect_body(loop);
        for (const flow::NodeId node : loop.body) {
            for (const flow::EdgeId out : graph_.out[node])
                if (mark_[graph_.edges[out].to] != round_) loop.ways_out.push_back(out);
            loop.can_stop |= std::ranges::binary_search(exits_, node);
            look_at_effects(loop, node);
        }
        for_each_in_body(loop, analysis_.facts().calls, [&](const CallMade& call) {
            loop.can_stop |= call.may_stop;
            loop.has_unknown_effects |= !call.known;
        });
        if (edge.kind == flow::EdgeKind::back) {
            const Slice effects = graph_.nodes[loop.head].effects;
            for (Id i = effects.first; i < effects.first + effects.count; ++i)
                if (const auto found = by_open_.find(i); found != by_open_.end())
                    loop.structure = found->second;
        }
        return loop;
    }

    /// Everything from which the latch is reached without passing the head.
    void collect_body(Loop& loop) {
        ++round_;
        mark_[loop.head] = round_;
        loop.body.push_back(loop.head);
        std::vector<flow::NodeId> stack;
        const auto add = [&](flow::NodeId node) {
            if (mark_[node] == round_) return;
            mark_[node] = round_;
            loop.body.push_back(node);
            stack.push_back(node);
        };
        add(loop.latch);
        while (!stack.empty() && budget_ != 0) {
            const flow::NodeId node = stack.back();
            stack.pop_back();
            --budget_;
            for (const flow::EdgeId in : graph_.in[node])
                if (analysis_.passable(in)) add(graph_.edges[in].from);
        }
        std::ranges::sort(loop.body);
    }

    void look_at_effects(Loop& loop, flow::NodeId node) const {
        for (const Effect& effect : program_.effects_in(graph_.nodes[node].effects)) {
            std::visit(overloaded{
                           [&](const Stop&) { loop.can_stop = true; },
                           [&](const UnreadableBlock&) { loop.has_unknown_effects = true; },
                           [](const auto&) {},
                       },
                       effect.what);
        }
    }

    const Program& program_;
    const flow::Graph& graph_;
    const Analysis& analysis_;
    std::size_t budget_;
    std::vector<std::uint32_t> mark_;
    std::uint32_t round_ = 0;
    std::unordered_map<EffectId, flow::StructureId> by_open_;
    std::vector<flow::NodeId> exits_;
};

} // namespace

bool Loop::holds(flow::NodeId node) const { return std::ranges::binary_search(body, node); }

std::vector<Loop> find_loops(const Program& program, const flow::Structures& structures,
                             const flow::Graph& graph, const Analysis& analysis) {
    return LoopSearch(program, structures, graph, analysis).run();
}

std::vector<const Store*> stores_in(const Loop& loop, const Facts& facts, Place place) {
    std::vector<const Store*> stores;
    for_each_in_body(loop, facts.stores, [&](const Store& store) {
        if (store.place == place) stores.push_back(&store);
    });
    return stores;
}

LoopChanges::LoopChanges(const Loop& loop, const Facts& facts) {
    for_each_in_body(loop, facts.stores,
                     [&](const Store& store) { assigned_.push_back(key_of(store.place)); });
    for_each_in_body(loop, facts.disturbances, [&](const Disturbance& disturbance) {
        if (disturbance.place)
            disturbed_.push_back(key_of(*disturbance.place));
        else if (std::ranges::find(spaces_, disturbance.space) == spaces_.end())
            spaces_.push_back(disturbance.space);
    });
    std::ranges::sort(assigned_);
    std::ranges::sort(disturbed_);
}

bool LoopChanges::assigned(Place place) const { return std::ranges::binary_search(assigned_, key_of(place)); }

bool LoopChanges::disturbed(Place place) const {
    return std::ranges::find(spaces_, place.space) != spaces_.end() ||
           std::ranges::binary_search(disturbed_, key_of(place));
}

namespace {

/// Finds the counter of one loop, or why there is none.
class CounterSearch {
  public:
    CounterSearch(const Program& program, const flow::Graph& graph, const Facts& facts, const Loop& loop)
        : program_(program)
        , graph_(graph)
        , facts_(facts)
        , loop_(loop)
        , changes_(loop, facts) {}

    std::optional<Counter> run() {
        for (const flow::EdgeId id : loop_.ways_out) {
            const flow::Edge& edge = graph_.edges[id];
            if (!edge.condition || !add_test(edge)) return std::nullopt;
        }
        if (!counter_ || changes_.disturbed(counter_->place)) return std::nullopt;
        for (const Store* store : stores_in(loop_, facts_, counter_->place)) {
            if (store->step)
                counter_->steps.push_back(store);
            else if (is_clamp(*store))
                counter_->clamps.push_back(store);
            else
                return std::nullopt;
        }
        return counter_->steps.empty() ? std::nullopt : std::move(counter_);
    }

  private:
    [[nodiscard]] bool is_fixed(ExpressionId expression) const {
        const ReadSet set = variables_of(program_, expression);
        return set.closed &&
               std::ranges::none_of(set.places, [this](Place place) { return changes_.may_change(place); });
    }

    /// A side that is the variable, or minus the variable.
    [[nodiscard]] std::optional<std::pair<Place, bool>> side(ExpressionId id) const {
        bool negated = false;
        const auto* apply = std::get_if<Apply>(&program_.expressions[id].node);
        if (apply != nullptr && apply->operation == Operation::negate) {
            negated = true;
            id = program_.operands_of(*apply).front();
        }
        const auto* load = std::get_if<Load>(&program_.expressions[id].node);
        if (load == nullptr || !changes_.may_change(load->place)) return std::nullopt;
        return std::pair(load->place, negated);
    }

    bool add_test(const flow::Edge& edge) {
        auto found = std::ranges::lower_bound(facts_.comparisons, edge.from, {}, &Comparison::node);
        while (found != facts_.comparisons.end() && found->node == edge.from &&
               found->expression != *edge.condition)
            ++found;
        if (found == facts_.comparisons.end() || found->node != edge.from || !is_comparison(found->operation))
            return false;
        // The way out is taken when the comparison `holds`; the loop goes on otherwise.
        Operation stays = edge.holds ? opposite(found->operation) : found->operation;
        ExpressionId bound = found->right_expression;
        const Value* bound_value = &found->right;
        auto variable = side(found->left_expression);
        if (!variable) {
            variable = side(found->right_expression);
            bound = found->left_expression;
            bound_value = &found->left;
            stays = mirrored(stays);
        }
        if (!variable || !is_fixed(bound)) return false;
        if (variable->second) stays = mirrored(stays);
        if (!counter_) counter_ = Counter{variable->first, {}, {}, {}};
        if (!(counter_->place == variable->first)) return false;
        counter_->tests.push_back({&*found, stays, bound, bound_value});
        return true;
    }

    /// IF[#13GT#26]THEN#13=#26
    [[nodiscard]] bool is_clamp(const Store& store) const {
        const auto guarded = [&](flow::EdgeId id) {
            const auto& condition = graph_.edges[id].condition;
            if (!condition) return false;
            const ReadSet set = variables_of(program_, *condition);
            return std::ranges::find(set.places, store.place) != set.places.end();
        };
        return !graph_.in[store.node].empty() && std::ranges::all_of(graph_.in[store.node], guarded);
    }

    const Program& program_;
    const flow::Graph& graph_;
    const Facts& facts_;
    const Loop& loop_;
    LoopChanges changes_;
    std::optional<Counter> counter_;
};

} // namespace

std::optional<Counter> counter_of(const Program& program, const flow::Graph& graph, const Facts& facts,
                                  const Loop& loop) {
    return CounterSearch(program, graph, facts, loop).run();
}

} // namespace maclint::dataflow
