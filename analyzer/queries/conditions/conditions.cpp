//! Walks over expression trees.
#include "analyzer/queries/conditions/conditions.hpp"

#include "analyzer/dataflow/facts/comparison.hpp"
#include "analyzer/dataflow/facts/condition.hpp"
#include "analyzer/program/overloaded.hpp"

#include <algorithm>

namespace maclint::queries {
namespace {

using semantics::is_vacancy_test;

const Apply* as_apply(const Program& program, ExpressionId id) {
    return std::get_if<Apply>(&program.expressions[id].node);
}

} // namespace

std::optional<Variable> plain_variable(const Program& program, ExpressionId expression) {
    const auto* load = std::get_if<Load>(&program.expressions[expression].node);
    return load == nullptr ? std::nullopt : std::optional(load->variable);
}

bool same_expression(const Program& program, ExpressionId a, ExpressionId b) {
    if (a == b) return true;
    const auto& other = program.expressions[b].node;
    return std::visit(overloaded{
                          [&](const Literal& x) {
                              const auto* y = std::get_if<Literal>(&other);
                              return y != nullptr && x.value == y->value;
                          },
                          [&](const Vacant&) { return std::holds_alternative<Vacant>(other); },
                          [&](const Load& x) {
                              const auto* y = std::get_if<Load>(&other);
                              return y != nullptr && x.variable == y->variable;
                          },
                          [&](const LoadAt& x) {
                              const auto* y = std::get_if<LoadAt>(&other);
                              return y != nullptr && x.family == y->family &&
                                     same_expression(program, x.index, y->index);
                          },
                          [&](const LoadModal& x) {
                              const auto* y = std::get_if<LoadModal>(&other);
                              return y != nullptr && x.group == y->group;
                          },
                          [&](const LoadMachine& x) {
                              const auto* y = std::get_if<LoadMachine>(&other);
                              return y != nullptr && x.family == y->family && x.number == y->number;
                          },
                          [&](const Apply& x) {
                              const auto* y = std::get_if<Apply>(&other);
                              if (y == nullptr || x.operation != y->operation) return false;
                              return std::ranges::equal(program.operands_of(x), program.operands_of(*y),
                                                        [&](ExpressionId p, ExpressionId q) {
                                                            return same_expression(program, p, q);
                                                        });
                          },
                          [](const auto&) { return false; },
                      },
                      program.expressions[a].node);
}

bool asks_for_vacancy(const Program& program, const dataflow::Facts& facts, flow::NodeId first,
                      flow::NodeId last, Variable variable) {
    const auto& all = facts.all<dataflow::Comparison>();
    for (auto test = std::ranges::lower_bound(all, first, {}, &dataflow::Comparison::node);
         test != all.end() && test->node <= last; ++test)
        if (is_vacancy_test(test->operation) && plain_variable(program, test->left_expression) == variable)
            return true;
    return false;
}

namespace {

bool stands_in_later_part(const Program& program, ExpressionId condition, Span expression) {
    const Apply* apply = as_apply(program, condition);
    if (apply == nullptr) return false;
    const auto operands = program.operands_of(*apply);
    const bool chain = apply->operation == Operation::all_of || apply->operation == Operation::any_of;
    for (std::size_t i = 0; i < operands.size(); ++i)
        if (program.expressions[operands[i]].span.covers(expression))
            return (chain && i > 0) || stands_in_later_part(program, operands[i], expression);
    return false;
}

} // namespace

bool may_be_left_out(const Program& program, const dataflow::Facts& facts, EffectId effect,
                     ExpressionId expression) {
    return std::ranges::any_of(
        facts.at<dataflow::Condition>(effect), [&](const dataflow::Condition& condition) {
            return stands_in_later_part(program, condition.expression, program.expressions[expression].span);
        });
}

bool tests_any_vacancy(const Program& program, ExpressionId expression) {
    const Apply* apply = as_apply(program, expression);
    if (apply == nullptr) return false;
    return is_vacancy_test(apply->operation) ||
           std::ranges::any_of(program.operands_of(*apply),
                               [&](ExpressionId operand) { return tests_any_vacancy(program, operand); });
}

const dataflow::Comparison* zero_test_of(const ProgramAnalysis& analysis, const dataflow::Read& read) {
    for (const dataflow::Comparison& comparison : analysis.facts().in<dataflow::Comparison>(read.node)) {
        if (comparison.operation != Operation::equal && comparison.operation != Operation::not_equal)
            continue;
        const bool left = comparison.left_expression == read.expression;
        if (!left && comparison.right_expression != read.expression) continue;
        if ((left ? comparison.right : comparison.left).constant() == 0.0) return &comparison;
    }
    return nullptr;
}

} // namespace maclint::queries
