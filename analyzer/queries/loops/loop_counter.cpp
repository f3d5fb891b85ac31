//! Looks at every exit of a loop, and at every assignment in it.
#include "analyzer/queries/loops/loop_counter.hpp"

#include "analyzer/dataflow/domain/arithmetic.hpp"
#include "analyzer/dataflow/domain/read_set.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace maclint::queries {
namespace {

/// The assignments in the loop's body that change the variable.
std::vector<const dataflow::Store*> stores_in(const dataflow::Loop& loop, const dataflow::Facts& facts,
                                              Variable variable) {
    std::vector<const dataflow::Store*> stores;
    dataflow::for_each_in_body(loop, facts.all<dataflow::Store>(), [&](const dataflow::Store& store) {
        if (store.variable == variable) stores.push_back(&store);
    });
    return stores;
}

/// How sure it is that a bound stays as it is.
enum class Fixed : std::uint8_t { surely, by_the_text };

/// Finds the counter of one loop, or why there is none.
class CounterSearch {
  public:
    CounterSearch(const Program& program, const flow::Graph& graph, const dataflow::Facts& facts,
                  const dataflow::Loop& loop)
        : program_(program)
        , graph_(graph)
        , facts_(facts)
        , loop_(loop) {}

    std::optional<Counter> run() {
        std::optional<Counter> counter;
        for (const flow::EdgeId id : loop_.exit_edges) {
            const auto test = test_on(graph_.edges[id], Fixed::surely);
            if (!test) return std::nullopt;
            if (!counter) counter = Counter{test->variable, {}, {}, {}};
            if (!(counter->variable == test->variable)) return std::nullopt;
            counter->tests.push_back(test->test);
        }
        if (!counter || loop_.changes.clobbered(counter->variable) || !add_steps(*counter))
            return std::nullopt;
        return counter;
    }

    std::vector<Counter> run_for_any() {
        std::vector<Counter> counters;
        for (const flow::EdgeId id : loop_.exit_edges) {
            const auto test = test_on(graph_.edges[id], Fixed::by_the_text);
            if (!test) continue;
            auto counter = std::ranges::find(counters, test->variable, &Counter::variable);
            if (counter == counters.end())
                counter = counters.insert(counter, Counter{test->variable, {}, {}, {}});
            counter->tests.push_back(test->test);
        }
        std::erase_if(counters, [this](Counter& counter) { return !add_steps(counter); });
        return counters;
    }

  private:
    struct TestOf {
        Variable variable;
        CounterTest test;
    };

    /// The assignments to the counter in the loop; false where it has other ones than steps and clamps, or no
    /// step.
    bool add_steps(Counter& counter) {
        for (const dataflow::Store* store : stores_in(loop_, facts_, counter.variable)) {
            if (store->step)
                counter.steps.push_back(store);
            else if (is_clamp(*store))
                counter.clamps.push_back(store);
            else
                return false;
        }
        return !counter.steps.empty();
    }

    [[nodiscard]] bool is_fixed(ExpressionId expression, Fixed fixed) const {
        const dataflow::ReadSet set = dataflow::variables_of(program_, expression);
        return set.closed && std::ranges::none_of(set.variables, [&](Variable variable) {
                   return fixed == Fixed::surely ? loop_.changes.may_change(variable)
                                                 : loop_.changes.assigned(variable);
               });
    }

    /// A side that is the variable, or minus the variable.
    [[nodiscard]] std::optional<std::pair<Variable, bool>> side(ExpressionId id) const {
        bool negated = false;
        const auto* apply = std::get_if<Apply>(&program_.expressions[id].node);
        if (apply != nullptr && apply->operation == Operation::negate) {
            negated = true;
            id = program_.operands_of(*apply).front();
        }
        const auto* load = std::get_if<Load>(&program_.expressions[id].node);
        if (load == nullptr || !loop_.changes.may_change(load->variable)) return std::nullopt;
        return std::pair(load->variable, negated);
    }

    /// The test of a counter by which the edge leaves the loop.
    [[nodiscard]] std::optional<TestOf> test_on(const flow::Edge& edge, Fixed fixed) const {
        if (!edge.condition) return std::nullopt;
        const auto comparisons = facts_.in<dataflow::Comparison>(edge.from);
        const auto found = std::ranges::find(comparisons, *edge.condition, &dataflow::Comparison::expression);
        if (found == comparisons.end() || !dataflow::is_comparison(found->operation)) return std::nullopt;
        // The exit is taken when the comparison `holds`; the loop goes on otherwise.
        Operation stays = edge.holds ? dataflow::opposite(found->operation) : found->operation;
        ExpressionId bound = found->right_expression;
        const dataflow::Value* bound_value = &found->right;
        auto variable = side(found->left_expression);
        if (!variable) {
            variable = side(found->right_expression);
            bound = found->left_expression;
            bound_value = &found->left;
            stays = dataflow::mirrored(stays);
        }
        if (!variable || !is_fixed(bound, fixed)) return std::nullopt;
        if (variable->second) stays = dataflow::mirrored(stays);
        return TestOf{variable->first, {&*found, stays, bound, bound_value}};
    }

    /// IF[#13GT#26]THEN#13=#26
    [[nodiscard]] bool is_clamp(const dataflow::Store& store) const {
        const auto guarded = [&](flow::EdgeId id) {
            const auto& condition = graph_.edges[id].condition;
            if (!condition) return false;
            const dataflow::ReadSet set = dataflow::variables_of(program_, *condition);
            return std::ranges::find(set.variables, store.variable) != set.variables.end();
        };
        return !graph_.in[store.node].empty() && std::ranges::all_of(graph_.in[store.node], guarded);
    }

    const Program& program_;
    const flow::Graph& graph_;
    const dataflow::Facts& facts_;
    const dataflow::Loop& loop_;
};

} // namespace

std::optional<Counter> counter_of(const ProgramAnalysis& analysis, const dataflow::Loop& loop) {
    return CounterSearch(analysis.program(), analysis.graph(), analysis.facts(), loop).run();
}

std::vector<Counter> counters_of(const ProgramAnalysis& analysis, const dataflow::Loop& loop) {
    return CounterSearch(analysis.program(), analysis.graph(), analysis.facts(), loop).run_for_any();
}

} // namespace maclint::queries
