//! Expressions and conditions.
#include "analyzer/execution/stepper.hpp"
#include "analyzer/program/overloaded.hpp"
#include "analyzer/program/tables.hpp"

#include <algorithm>

namespace maclint::execution {
namespace {

using semantics::is_comparison;

bool is_logic(Operation operation) {
    return operation >= Operation::all_of && operation <= Operation::not_of;
}

} // namespace

/// The value that something is done with.
Content Stepper::take(ExpressionId id) {
    const Content content = evaluate(id);
    if (!done()) report(ValueTaken{id, content});
    return content;
}

Content Stepper::evaluate(ExpressionId id) {
    if (done()) return {};
    return std::visit(overloaded{
                          [](const Literal& literal) { return Content{literal.value + 0.0}; }, // no -0
                          [](const Vacant&) { return Content{}; },
                          [&](const Load& what) { return load(id, what.variable); },
                          [&](const LoadAt& what) { return load_at(id, what); },
                          [&](const LoadModal& what) { return load_group(id, what.group); },
                          [&](const Apply& what) { return apply(id, what); },
                          [&](const auto&) { return environment_.value_of(text(), id); },
                      },
                      text().expressions[id].node);
}

Content Stepper::load(ExpressionId id, Variable variable) {
    const Content content = content_of(variable);
    report(VariableRead{id, variable, content});
    return content;
}

Content Stepper::load_at(ExpressionId id, const LoadAt& load) {
    const double index = evaluate(load.index).value_or(0);
    if (done()) return {};
    const auto number = semantics::variable_number(index);
    const VariableRange* range = number ? control().families[load.family].find(*number) : nullptr;
    if (range == nullptr || range->meaning == Meaning::absent) {
        fault(); // alarm 115
        return {};
    }
    switch (range->meaning) {
    case Meaning::null: return {};
    case Meaning::variable: return this->load(id, {range->space, *number});
    case Meaning::modal: return load_group(id, range->group);
    default: return environment_.value_of(text(), id);
    }
}

Content Stepper::load_group(ExpressionId id, GroupId group) {
    const double code = this->code(group);
    report(GroupRead{id, group, code});
    return code;
}

Content Stepper::apply(ExpressionId id, const Apply& apply) {
    const auto operands = text().operands_of(apply);
    std::vector<Content> contents;
    contents.reserve(operands.size());
    for (const ExpressionId operand : operands) contents.push_back(evaluate(operand));
    if (done()) return {};
    // Conditions give no value [SINHA-EXP].
    const bool is_value = !is_comparison(apply.operation) && !is_logic(apply.operation) &&
                          !semantics::is_vacancy_test(apply.operation);
    if (is_value && (contents.size() == 1 || contents.size() == 2))
        report(Applied{id, contents.front(), contents.back()});
    const semantics::Result result =
        is_value ? semantics::compute(apply.operation, std::span<const Content>(contents))
                 : semantics::NotModelled{};
    if (std::holds_alternative<semantics::NotModelled>(result)) return environment_.value_of(text(), id);
    const auto* number = std::get_if<double>(&result);
    if (number == nullptr || !semantics::is_in_range(*number)) {
        fault();
        return {};
    }
    return *number;
}

bool Stepper::decide(ExpressionId condition) {
    const bool decided = truth(condition);
    if (!done()) report(Decided{condition, decided});
    return decided;
}

/// All parts of a condition are computed, whatever the first one says.
bool Stepper::truth(ExpressionId id) {
    const auto* apply = std::get_if<Apply>(&text().expressions[id].node);
    if (apply == nullptr) return evaluate(id).value_or(0) != 0;
    const auto operands = text().operands_of(*apply);
    if (!is_logic(apply->operation)) return compare(id, *apply);
    std::size_t true_ones = 0;
    for (const ExpressionId operand : operands)
        if (truth(operand)) ++true_ones;
    switch (apply->operation) {
    case Operation::all_of: return true_ones == operands.size();
    case Operation::any_of: return true_ones != 0;
    case Operation::one_of: return true_ones == 1;
    default: return true_ones == 0;
    }
}

bool Stepper::compare(ExpressionId id, const Apply& apply) {
    const auto operands = text().operands_of(apply);
    const bool test = semantics::is_vacancy_test(apply.operation);
    if (!test && !(is_comparison(apply.operation) && operands.size() == 2))
        return evaluate(id).value_or(0) != 0;
    const Content left = evaluate(operands[0]);
    const Content right = test ? left : evaluate(operands[1]);
    if (done()) return false;
    const bool truth = test ? semantics::test_vacancy(apply.operation, left)
                            : semantics::compare(apply.operation, left, right, control().vacant_equals_zero);
    report(Compared{id, left, right, truth});
    return truth;
}

} // namespace maclint::execution
