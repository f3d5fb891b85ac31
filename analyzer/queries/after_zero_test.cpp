//! Goes on from the side of the test that vacant takes.
#include "analyzer/queries/after_zero_test.hpp"

#include "analyzer/dataflow/facts/store.hpp"
#include "analyzer/dialect/ascii.hpp"
#include "analyzer/execution/given_up.hpp"
#include "analyzer/queries/conditions.hpp"
#include "analyzer/queries/exits.hpp"
#include "analyzer/queries/feasible_paths.hpp"
#include "analyzer/queries/origins.hpp"

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace maclint::queries {
namespace {

using dataflow::Comparison;
using dataflow::Read;
using dataflow::Use;
using dataflow::Vacancy;
using dataflow::Value;

/// So many nodes behind a test are looked at for a use.
constexpr std::size_t most_nodes = 2000;

class VacantPath {
  public:
    VacantPath(const ProgramAnalysis& analysis, const Comparison& test, const Value& tested,
               Variable variable)
        : analysis_(analysis)
        , test_(test)
        , tested_(tested)
        , variable_(variable)
        , seen_(analysis.graph().nodes.size(), false)
        , checks_(ends_in_alarm(analysis, test.node, test.operation == Operation::equal)) {}

    /// The first use, in the order of the paths' lengths, to which the program can come.
    std::optional<Span> first_use() {
        take_edges(test_.node);
        std::size_t next = 0;
        while (next < pending_.size()) { // it grows on the way
            if (next == most_nodes) {
                execution::GivenUp::note(analysis_.search_memory());
                break;
            }
            const flow::NodeId node = pending_[next++];
            if (const auto use = use_in(node); use && can_follow(analysis_, test_.node, node)) return use;
            if (!sets_variable(node)) take_edges(node);
        }
        return std::nullopt;
    }

  private:
    /// Whether a condition that is this very comparison turns out so for vacant; nothing where vacant does
    /// not decide it.
    [[nodiscard]] std::optional<bool> outcome_of(ExpressionId condition, flow::NodeId node) const {
        for (const Comparison& comparison : analysis_.facts().in<Comparison>(node)) {
            if (comparison.expression != condition) continue;
            const auto& program = analysis_.program();
            if (plain_variable(program, comparison.left_expression) != variable_ &&
                plain_variable(program, comparison.right_expression) != variable_)
                return std::nullopt;
            switch (comparison.operation) {
            case Operation::is_vacant:
            case Operation::not_equal: return true;
            case Operation::is_set:
            case Operation::equal: return false;
            default: return std::nullopt;
            }
        }
        return std::nullopt;
    }

    void take_edges(flow::NodeId node) {
        for (const flow::EdgeId id : analysis_.graph().out[node]) {
            const flow::Edge& edge = analysis_.graph().edges[id];
            if (!analysis_.data().passable(id) || seen_[edge.to]) continue;
            if (edge.condition) {
                const auto outcome = outcome_of(*edge.condition, node);
                if (outcome && *outcome != edge.holds) continue;
            }
            seen_[edge.to] = true;
            pending_.push_back(edge.to);
        }
    }

    [[nodiscard]] std::optional<Span> use_in(flow::NodeId node) const {
        const auto reads = analysis_.facts().in<Read>(node);
        const auto found = std::ranges::find_if(reads, [&](const Read& read) {
            const bool counts = read.use == Use::arithmetic || (checks_ && read.use == Use::word);
            return counts && is_tested_value(read);
        });
        if (found != reads.end()) return analysis_.program().expressions[found->expression].span;
        return checks_ ? unreadable_use_in(node) : std::nullopt;
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
        return without_blanks(analysis_.program().slice(span))
                   .find(in_capitals(analysis_.program().spell(variable_)) + "=") != std::string::npos;
    }

    [[nodiscard]] bool is_tested_value(const Read& read) const {
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
    bool checks_; ///< the side that is meant for 0 leads straight to an alarm
};

bool is_path_without_assignment(const ProgramAnalysis& analysis, Variable variable, flow::NodeId node) {
    execution::PathSearch search(analysis);
    const execution::PathFound found = path_without_assignment(search, analysis, variable, node);
    return found.path || found.gave_up;
}

} // namespace

std::optional<Span> use_after_zero_test(const ProgramAnalysis& analysis, const Comparison& test,
                                        const Value& tested, Variable variable) {
    if (variable_of_origin(analysis, tested.vacancy_origin) == variable &&
        analysis.data().is_vacant_at_entry(variable) &&
        !is_path_without_assignment(analysis, variable, test.node))
        return std::nullopt;
    return VacantPath(analysis, test, tested, variable).first_use();
}

} // namespace maclint::queries
