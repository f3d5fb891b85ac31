//! Goes on from the side of the test that vacant takes.
#include "rules/variables/zero_test_misses_vacant_uses_finder.hpp"

#include "analyzer/dataflow/facts/store.hpp"
#include "analyzer/dialect/ascii.hpp"
#include "analyzer/program/tables.hpp"
#include "analyzer/queries/conditions/conditions.hpp"
#include "analyzer/queries/paths/feasible_paths.hpp"
#include "analyzer/queries/values/origins.hpp"
#include "analyzer/semantics/concrete.hpp"

#include <algorithm>
#include <cstddef>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace maclint::rules {
namespace {

using dataflow::Comparison;
using dataflow::Read;
using dataflow::Use;
using dataflow::Vacancy;
using dataflow::Value;

/// Nodes behind a test that are looked at for a use, and nodes before it that are looked at for a way to it.
constexpr std::size_t most_nodes = 2000, most_nodes_before = 20'000;

class VacantPath {
  public:
    VacantPath(const ProgramAnalysis& analysis, const Comparison& test, const Value& tested,
               Variable variable)
        : analysis_(analysis)
        , test_(test)
        , tested_(tested)
        , variable_(variable)
        , seen_(analysis.graph().nodes.size(), false) {}

    /// Whether a path leads from the program's start to the test on which no text sets the variable, and no
    /// test tells that it is not vacant.
    bool is_reached_vacant() {
        pending_.assign(1, 0);
        seen_.assign(seen_.size(), false);
        seen_[0] = true;
        std::size_t next = 0;
        while (next < pending_.size() && !seen_[test_.node]) { // it grows on the way
            if (next == most_nodes_before) {
                analysis_.search_memory().count(true);
                break;
            }
            const flow::NodeId node = pending_[next++];
            if (!sets_variable(node)) take_edges(node);
        }
        return seen_[test_.node];
    }

    AfterZeroTest find() {
        pending_.clear();
        seen_.assign(seen_.size(), false);
        AfterZeroTest found{.is_reached = true, .is_default = sets_on_the_side_of_zero()};
        take_edges(test_.node);
        std::size_t next = 0;
        while (next < pending_.size() && !found.use) { // it grows on the way
            if (next == most_nodes) {
                analysis_.search_memory().count(true);
                break;
            }
            const flow::NodeId node = pending_[next++];
            look_at(node, found);
            if (!sets_variable(node)) take_edges(node);
        }
        return found;
    }

  private:
    /// What an expression is while the variable is vacant; nothing where it is not known.
    [[nodiscard]] std::optional<semantics::Content> content_of(ExpressionId id) const {
        const auto& node = analysis_.program().expressions[id].node;
        if (const auto* literal = std::get_if<Literal>(&node)) return semantics::Content{literal->value};
        if (std::holds_alternative<Vacant>(node) ||
            queries::plain_variable(analysis_.program(), id) == variable_)
            return semantics::Content{};
        return std::nullopt;
    }

    /// Whether a condition is true while the variable is vacant; nothing where that does not decide it.
    [[nodiscard]] std::optional<bool> outcome_of(ExpressionId condition) const {
        const auto* apply = std::get_if<Apply>(&analysis_.program().expressions[condition].node);
        if (apply == nullptr) return std::nullopt;
        const auto operands = analysis_.program().operands_of(*apply);
        switch (apply->operation) {
        case Operation::all_of: return outcome_of_several(operands, false);
        case Operation::any_of: return outcome_of_several(operands, true);
        default: break;
        }
        const bool is_vacancy_test = semantics::is_vacancy_test(apply->operation);
        if (!is_vacancy_test && !(semantics::is_comparison(apply->operation) && operands.size() == 2))
            return std::nullopt;
        const auto left = content_of(operands.front());
        const auto right = content_of(operands.back());
        if (!left || !right) return std::nullopt;
        return is_vacancy_test ? semantics::test_vacancy(apply->operation, *left)
                               : semantics::compare(apply->operation, *left, *right,
                                                    analysis_.control().vacant_equals_zero);
    }

    /// Of parts of which one that is `deciding` decides.
    [[nodiscard]] std::optional<bool> outcome_of_several(std::span<const ExpressionId> parts,
                                                         bool deciding) const {
        std::optional<bool> all = !deciding;
        for (const ExpressionId part : parts) {
            const auto outcome = outcome_of(part);
            if (outcome == deciding) return deciding;
            if (!outcome) all.reset();
        }
        return all;
    }

    /// Whether 0 is replaced by another value at once.
    [[nodiscard]] bool sets_on_the_side_of_zero() const {
        return std::ranges::any_of(analysis_.graph().out[test_.node], [&](flow::EdgeId id) {
            const flow::Edge& edge = analysis_.graph().edges[id];
            return edge.condition && outcome_of(*edge.condition) == !edge.holds &&
                   std::ranges::any_of(
                       analysis_.facts().in<dataflow::Store>(edge.to), [&](const dataflow::Store& store) {
                           return store.variable == variable_ && store.value.constant() != 0.0;
                       });
        });
    }

    void take_edges(flow::NodeId node) {
        for (const flow::EdgeId id : analysis_.graph().out[node]) {
            const flow::Edge& edge = analysis_.graph().edges[id];
            if (!analysis_.data().passable(id) || seen_[edge.to]) continue;
            if (edge.condition) {
                const auto outcome = outcome_of(*edge.condition);
                if (outcome && *outcome != edge.holds) continue;
            }
            seen_[edge.to] = true;
            pending_.push_back(edge.to);
        }
    }

    void look_at(flow::NodeId node, AfterZeroTest& found) const {
        const auto note = [&](std::optional<Span>& place, Span span) {
            if (!place && queries::can_follow(analysis_, test_.node, node)) place = span;
        };
        const bool had_compared = found.compared.has_value();
        for (const Read& read : analysis_.facts().in<Read>(node)) {
            if (!is_tested_value(read) || (read.use == Use::copy && !leaves_program(node))) continue;
            note(read.use == Use::vacancy_test ? found.asked
                 : read.use == Use::comparison ? found.compared
                                               : found.use,
                 analysis_.program().expressions[read.expression].span);
        }
        if (!had_compared && found.compared)
            found.is_held_in_range = std::ranges::none_of(
                analysis_.facts().in<Comparison>(node), [](const Comparison& comparison) {
                    return comparison.operation == Operation::equal ||
                           comparison.operation == Operation::not_equal;
                });
        if (const auto unreadable = unreadable_use_in(node)) note(found.use, *unreadable);
    }

    /// Whether what is stored there is for other programs, too.
    [[nodiscard]] bool leaves_program(flow::NodeId node) const {
        return std::ranges::any_of(
            analysis_.facts().in<dataflow::Store>(node), [&](const dataflow::Store& store) {
                return analysis_.control().spaces[store.variable.space].scope != Scope::frame;
            });
    }

    [[nodiscard]] std::optional<Span> unreadable_use_in(flow::NodeId node) const {
        for (const Effect& effect : analysis_.program().effects_in(analysis_.graph().nodes[node].effects)) {
            const auto* block = std::get_if<UnreadableBlock>(&effect.what);
            if (block == nullptr || block->may_open_or_close) continue;
            const auto named = analysis_.program().variables_of(*block);
            if (std::ranges::find(named, variable_) != named.end() && !may_assign(effect.span))
                return effect.span;
        }
        return std::nullopt;
    }

    /// Whether the variable's name stands there with a sign of equality behind it.
    [[nodiscard]] bool may_assign(Span span) const {
        return exemptions::assigned_unread.is_on() &&
               without_blanks(analysis_.program().slice(span))
                       .find(in_capitals(analysis_.program().spell(variable_)) + "=") != std::string::npos;
    }

    [[nodiscard]] bool is_tested_value(const Read& read) const {
        if (tested_.vacancy == Vacancy::unknown) return read.variable == variable_;
        if (read.value.vacancy != Vacancy::vacant && read.value.vacancy != Vacancy::maybe) return false;
        return read.value.symbol == tested_.symbol ||
               (read.variable == variable_ && read.value.vacancy_origin == tested_.vacancy_origin);
    }

    [[nodiscard]] bool sets_variable(flow::NodeId node) const {
        return std::ranges::any_of(analysis_.facts().in<dataflow::Store>(node),
                                   [&](const dataflow::Store& store) { return store.variable == variable_; });
    }

    const ProgramAnalysis& analysis_;
    const Comparison& test_;
    const Value& tested_;
    Variable variable_;
    std::vector<bool> seen_;
    std::vector<flow::NodeId> pending_;
};

bool is_path_without_assignment(const ProgramAnalysis& analysis, Variable variable, flow::NodeId node) {
    execution::PathSearch search(analysis);
    const execution::PathFound found = queries::path_without_assignment(search, analysis, variable, node);
    return found.path || found.gave_up;
}

} // namespace

AfterZeroTest find_after_zero_test(const ProgramAnalysis& analysis, const Comparison& test,
                                   const Value& tested, Variable variable) {
    if (queries::variable_of_origin(analysis, tested.vacancy_origin) == variable &&
        analysis.data().is_vacant_at_entry(variable) &&
        !is_path_without_assignment(analysis, variable, test.node))
        return {};
    VacantPath path(analysis, test, tested, variable);
    if (tested.vacancy_origin == 0 && !path.is_reached_vacant()) return {};
    return path.find();
}

} // namespace maclint::rules
