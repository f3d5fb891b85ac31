//! Looks for a path from the test for a number to the read, around all assignments.
#include "rules/variables/common_stale_read_cases_finder.hpp"

#include "analyzer/dataflow/domain/state.hpp"
#include "analyzer/dataflow/facts/clobber.hpp"
#include "analyzer/dataflow/facts/comparison.hpp"
#include "analyzer/dataflow/facts/store.hpp"
#include "analyzer/execution/path_search.hpp"
#include "analyzer/program/tables.hpp"
#include "analyzer/queries/calls/callers.hpp"
#include "analyzer/queries/conditions/conditions.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <set>
#include <span>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

namespace maclint::rules {
namespace {

using dataflow::Comparison;

constexpr int most_blocks = 16;          ///< from a test to an assignment that it decides
constexpr std::size_t most_searches = 8; ///< of one variable, in one case

/// A test whether the subject is a number, and where the program goes on when it is.
struct Case {
    const Comparison* test;
    ExpressionId number;
    flow::NodeId begins;
};

class StaleReads {
  public:
    explicit StaleReads(const ProgramAnalysis& analysis)
        : analysis_(analysis)
        , graph_(analysis.graph()) {
        for (const Comparison& test : analysis.facts().all<Comparison>()) {
            const auto tested = case_of(test);
            if (!tested) continue;
            case_of_.try_emplace(tested->begins, cases_.size());
            cases_.push_back(*tested);
        }
    }

    std::optional<StaleRead> of(Variable variable) {
        const auto set_for = cases_that_set(variable);
        if (set_for.cases.size() < 2) return std::nullopt;
        const auto reads = first_reads(analysis_, variable);
        if (reads.empty()) return std::nullopt;
        const auto setting = nodes_that_set(analysis_, variable);
        for (const Case& other : cases_) {
            if (set_for.numbers.contains(value(other.number)) ||
                !asks_for_same(*set_for.cases.front(), other))
                continue;
            if (auto found = read_in(other, reads, setting)) {
                for (const Case* one : set_for.cases) found->set_for.push_back(one->number);
                return found;
            }
        }
        return std::nullopt;
    }

    [[nodiscard]] bool has_cases() const { return cases_.size() > 2; }

  private:
    [[nodiscard]] std::span<const dataflow::Store* const> stores_in(Variable variable) const {
        return analysis_.facts().about<dataflow::Store>(variable);
    }

    [[nodiscard]] double value(ExpressionId number) const {
        return std::get<Literal>(analysis_.program().expressions[number].node).value;
    }

    /// Whether both test one thing, which nothing changes from the first test in the text on.
    [[nodiscard]] bool asks_for_same(const Case& one, const Case& other) const {
        const ExpressionId subject = one.test->left_expression;
        return queries::same_expression(analysis_.program(), subject, other.test->left_expression) &&
               stays(subject, std::min(one.test->effect, other.test->effect));
    }

    [[nodiscard]] bool stays(ExpressionId subject, EffectId from) const {
        const auto& node = analysis_.program().expressions[subject].node;
        if (const auto* machine = std::get_if<LoadMachine>(&node)) {
            const auto* range = analysis_.control().families[machine->family].find(machine->number);
            return range != nullptr && !range->changes_by_itself;
        }
        const auto* load = std::get_if<Load>(&node);
        if (load == nullptr) return std::holds_alternative<LoadModal>(node);
        return last_change_of(load->variable) <= from;
    }

    /// The last effect in the text that may change the variable; 0 for none.
    [[nodiscard]] EffectId last_change_of(Variable variable) const {
        const auto [known, fresh] = last_changes_.try_emplace(dataflow::key_of(variable), 0);
        if (!fresh) return known->second;
        for (const dataflow::Store* store : stores_in(variable))
            known->second = std::max(known->second, store->effect);
        for (const dataflow::Clobber& clobber : analysis_.facts().all<dataflow::Clobber>())
            if (clobber.may_change(variable)) known->second = std::max(known->second, clobber.effect);
        return known->second;
    }

    [[nodiscard]] std::optional<Case> case_of(const Comparison& test) const {
        const bool equal = test.operation == Operation::equal;
        if ((!equal && test.operation != Operation::not_equal) ||
            !std::holds_alternative<Literal>(analysis_.program().expressions[test.right_expression].node))
            return std::nullopt;
        for (const flow::EdgeId id : graph_.out[test.node]) {
            const flow::Edge& edge = graph_.edges[id];
            if (edge.condition == test.expression && edge.holds == equal && analysis_.data().passable(id))
                return Case{&test, test.right_expression, edge.to};
        }
        return std::nullopt;
    }

    struct CasesThatSet {
        std::vector<const Case*> cases;
        std::set<double> numbers; ///< of these
    };

    /// One for each number, of one subject.
    [[nodiscard]] CasesThatSet cases_that_set(Variable variable) const {
        CasesThatSet found;
        const Case* first = nullptr; // in the text
        for (const dataflow::Store* store : stores_in(variable)) {
            const Case* decides = case_before(store->node);
            if (decides == nullptr || (first != nullptr && !asks_for_same(*first, *decides)) ||
                !found.numbers.insert(value(decides->number)).second)
                continue;
            found.cases.push_back(decides);
            if (first == nullptr || decides->test->effect < first->test->effect) first = decides;
        }
        return found;
    }

    /// The test that has to be true for the program to come to the node.
    [[nodiscard]] const Case* case_before(flow::NodeId node) const {
        for (int i = 0; i < most_blocks; ++i) {
            const auto in = graph_.in[node];
            if (in.size() != 1) return nullptr;
            if (const auto begins = case_of_.find(node); begins != case_of_.end())
                return &cases_[begins->second];
            node = graph_.edges[in.front()].from;
        }
        return nullptr;
    }

    [[nodiscard]] std::optional<StaleRead> read_in(const Case& in_case,
                                                   std::span<const dataflow::Read* const> reads,
                                                   std::span<const flow::NodeId> setting) {
        for (const dataflow::Read* read : reads) {
            auto found = search_.find(std::array{execution::Leg{in_case.test->node, setting},
                                                 execution::Leg{in_case.begins, setting},
                                                 execution::Leg{read->node, setting}});
            if (found.path && is_taken(*found.path, in_case))
                return StaleRead{
                    read, in_case.test->left_expression, {}, in_case.number, *std::move(found.path)};
        }
        return std::nullopt;
    }

    /// Whether the path goes on from the test as it does for the number.
    [[nodiscard]] bool is_taken(const std::vector<flow::EdgeId>& path, const Case& in_case) const {
        return std::ranges::any_of(path, [&](flow::EdgeId id) {
            const flow::Edge& edge = graph_.edges[id];
            return edge.from == in_case.test->node && edge.to == in_case.begins &&
                   edge.holds == (in_case.test->operation == Operation::equal);
        });
    }

    const ProgramAnalysis& analysis_;
    const flow::Graph& graph_;
    execution::PathSearch search_{analysis_};
    std::vector<Case> cases_;
    std::unordered_map<flow::NodeId, std::size_t> case_of_; ///< the first that begins at the node
    mutable std::unordered_map<dataflow::Key, EffectId> last_changes_;
};

/// Whether the program stores in the variable.
bool is_set_in(const Program& program, Variable variable) {
    return std::ranges::any_of(program.effects, [&](const Effect& effect) {
        const auto* assign = std::get_if<Assign>(&effect.what);
        const auto* target = assign == nullptr ? nullptr : std::get_if<Variable>(&assign->target);
        return target != nullptr && *target == variable;
    });
}

} // namespace

std::vector<const dataflow::Read*> first_reads(const ProgramAnalysis& analysis, Variable variable) {
    std::vector<const dataflow::Read*> reads;
    for (const dataflow::Read* read : analysis.facts().about<dataflow::Read>(variable)) {
        if (read->use == dataflow::Use::vacancy_test) continue;
        reads.push_back(read);
        if (reads.size() == most_searches) break;
    }
    return reads;
}

std::vector<flow::NodeId> nodes_that_set(const ProgramAnalysis& analysis, Variable variable) {
    std::vector<flow::NodeId> nodes;
    for (const dataflow::Store* store : analysis.facts().about<dataflow::Store>(variable))
        nodes.push_back(store->node);
    for (const dataflow::Clobber& clobber : analysis.facts().all<dataflow::Clobber>())
        if (clobber.may_change(variable)) nodes.push_back(clobber.node);
    std::ranges::sort(nodes);
    const auto again = std::ranges::unique(nodes);
    nodes.erase(again.begin(), again.end());
    return nodes;
}

bool callers_set(const ProgramAnalysis& analysis, Variable variable) {
    const auto sets = [&](const Caller& caller) {
        const ProgramAnalysis& calling = queries::calling_program(analysis, caller);
        return is_set_in(calling.program(), variable) ||
               std::ranges::any_of(calling.facts().all<dataflow::Clobber>(),
                                   [&](const dataflow::Clobber& clobber) {
                                       return clobber.effect != caller.effect && clobber.may_change(variable);
                                   });
    };
    if (std::ranges::any_of(analysis.callers(), sets)) return true;
    const PossibleCallers possible = analysis.possible_callers();
    if (std::ranges::any_of(possible.first, sets)) return true;
    if (!possible.all) analysis.search_memory().count(true);
    return !possible.all;
}

std::vector<StaleRead> find_stale_reads(const ProgramAnalysis& analysis) {
    std::vector<StaleRead> found;
    std::unordered_set<dataflow::Key> seen;
    std::optional<StaleReads> search;
    for (const dataflow::Store& store : analysis.facts().all<dataflow::Store>()) {
        if (analysis.control().spaces[store.variable.space].scope != Scope::shared ||
            !seen.insert(dataflow::key_of(store.variable)).second)
            continue;
        if (!search) search.emplace(analysis);
        if (!search->has_cases()) break;
        if (callers_set(analysis, store.variable)) continue;
        if (auto stale = search->of(store.variable)) found.push_back(*std::move(stale));
    }
    return found;
}

} // namespace maclint::rules
