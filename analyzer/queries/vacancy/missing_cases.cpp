//! Asks of each test on the path where its other outcome leads.
#include "analyzer/queries/vacancy/missing_cases.hpp"

#include "analyzer/dataflow/facts/store.hpp"
#include "analyzer/flow/walk.hpp"
#include "analyzer/queries/conditions/conditions.hpp"
#include "analyzer/source/budget.hpp"

#include <algorithm>
#include <optional>

namespace maclint::queries {
namespace {

class CasesWithoutAssignment {
  public:
    CasesWithoutAssignment(const ProgramAnalysis& analysis, Variable variable, flow::NodeId read)
        : analysis_(analysis)
        , program_(analysis.program())
        , graph_(analysis.graph())
        , assigns_(graph_.nodes.size(), false) {
        for (const dataflow::Store* store : analysis.facts().about<dataflow::Store>(variable))
            if (store->node != read) assigns_[store->node] = true;
        comes_ = nodes_before(read, false);
        comes_around_ = nodes_before(read, true);
    }

    MissingCase run(std::span<const flow::EdgeId> path) {
        for (const flow::EdgeId id : path) {
            const flow::Edge& edge = graph_.edges[id];
            if (edge.condition && decides(edge)) add(*edge.condition, !edge.holds);
        }
        if (!only_equal_ || result_.subjects.size() != 1) result_.numbers.clear();
        const auto value = [&](ExpressionId id) { return *literal(id); };
        std::ranges::sort(result_.numbers, {}, value);
        const auto twice = std::ranges::unique(result_.numbers, {}, value);
        result_.numbers.erase(twice.begin(), twice.end());
        return std::move(result_);
    }

  private:
    /// For every node whether the read is reached from there, perhaps over no assignment.
    [[nodiscard]] std::vector<bool> nodes_before(flow::NodeId read, bool around) const {
        std::vector<bool> before(graph_.nodes.size(), false);
        before[read] = true;
        flow::walk<flow::Direction::backward>(graph_, {read}, [&](flow::EdgeId edge, flow::NodeId from) {
            if ((around && assigns_[from]) || !analysis_.data().passable(edge)) return flow::Step::refuse;
            before[from] = true;
            return flow::Step::go_on;
        });
        return before;
    }

    /// Whether the other outcome of the test leads to the read over an assignment only.
    [[nodiscard]] bool decides(const flow::Edge& edge) const {
        return std::ranges::any_of(graph_.out[edge.from], [&](flow::EdgeId id) {
            const flow::Edge& other = graph_.edges[id];
            return other.condition == edge.condition && other.holds != edge.holds &&
                   analysis_.data().passable(id) && comes_[other.to] && !comes_around_[other.to];
        });
    }

    /// Takes note of what the condition tests, which leads to an assignment when it is `holds`.
    void add(ExpressionId condition, bool holds) {
        const auto* apply = std::get_if<Apply>(&program_.expressions[condition].node);
        if (apply == nullptr) {
            only_equal_ = false;
            return;
        }
        const auto operands = program_.operands_of(*apply);
        if (apply->operation == (holds ? Operation::any_of : Operation::all_of)) {
            for (const ExpressionId operand : operands) add(operand, holds);
            return;
        }
        if (apply->operation == Operation::not_of) return add(operands.front(), !holds);
        if (apply->operation == Operation::any_of || apply->operation == Operation::all_of) {
            only_equal_ = false;
            for (const ExpressionId operand : operands) add(operand, holds);
            return;
        }
        add_subject(operands.front());
        const auto number = operands.size() == 2 ? literal(operands.back()) : std::nullopt;
        const Operation wanted = holds ? Operation::equal : Operation::not_equal;
        if (apply->operation == wanted && number)
            result_.numbers.push_back(operands.back());
        else
            only_equal_ = false;
    }

    [[nodiscard]] std::optional<double> literal(ExpressionId id) const {
        const auto* literal = std::get_if<Literal>(&program_.expressions[id].node);
        return literal == nullptr ? std::nullopt : std::optional(literal->value);
    }

    void add_subject(ExpressionId id) {
        const bool known = any_within_budget(
            result_.subjects, [&](ExpressionId subject) { return same_expression(program_, subject, id); });
        if (!known) result_.subjects.push_back(id);
    }

    const ProgramAnalysis& analysis_;
    const Program& program_;
    const flow::Graph& graph_;
    std::vector<bool> assigns_, comes_, comes_around_; ///< of every node
    MissingCase result_;
    bool only_equal_ = true;
};

} // namespace

MissingCase missing_case_on(const ProgramAnalysis& analysis, std::span<const flow::EdgeId> path,
                            Variable variable, flow::NodeId read) {
    return CasesWithoutAssignment(analysis, variable, read).run(path);
}

bool is_same_case(const Program& program, const MissingCase& a, const MissingCase& b) {
    const MissingCase& smaller = a.subjects.size() < b.subjects.size() ? a : b;
    const MissingCase& larger = &smaller == &a ? b : a;
    return !smaller.subjects.empty() && std::ranges::all_of(smaller.subjects, [&](ExpressionId id) {
        return any_within_budget(larger.subjects,
                                 [&](ExpressionId subject) { return same_expression(program, subject, id); });
    });
}

} // namespace maclint::queries
