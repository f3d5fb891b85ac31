//! Walks over expression trees, and what several decisions mean together.
#include "analyzer/queries/conditions.hpp"

#include "analyzer/dataflow/domain/arithmetic.hpp"
#include "analyzer/dataflow/facts/comparison.hpp"
#include "analyzer/dataflow/facts/condition.hpp"
#include "analyzer/program/overloaded.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace maclint::queries {
namespace {

using dataflow::is_comparison;
using dataflow::mirrored;
using dataflow::opposite;
using semantics::is_vacancy_test;

/// One comparison that is known to hold.
struct Atom {
    ExpressionId left, right;
    Operation operation;
};

const Apply* as_apply(const Program& program, ExpressionId id) {
    return std::get_if<Apply>(&program.expressions[id].node);
}

/// What must hold when the condition turned out so; choices between alternatives are left out.
void collect_atoms(const Program& program, ExpressionId id, bool holds, std::vector<Atom>& atoms) {
    const Apply* apply = as_apply(program, id);
    if (apply == nullptr) return;
    const auto operands = program.operands_of(*apply);
    const Operation operation = apply->operation;
    if (operation == Operation::not_of) return collect_atoms(program, operands.front(), !holds, atoms);
    if (operation == (holds ? Operation::all_of : Operation::any_of)) {
        for (const ExpressionId operand : operands) collect_atoms(program, operand, holds, atoms);
    } else if (is_vacancy_test(operation)) {
        atoms.push_back({operands.front(), operands.front(), holds ? operation : opposite(operation)});
    } else if (is_comparison(operation) && operands.size() == 2) {
        atoms.push_back({operands[0], operands[1], holds ? operation : opposite(operation)});
    }
}

constexpr unsigned below = 1, same = 2, above = 4;

/// Where the left side can lie beside the right one.
unsigned region(Operation operation) {
    switch (operation) {
    case Operation::less: return below;
    case Operation::less_equal: return below | same;
    case Operation::equal: return same;
    case Operation::greater_equal: return same | above;
    case Operation::greater: return above;
    default: return below | above;
    }
}

/// Cuts the number line at a smaller and a larger number into five parts: below, at and between them …
unsigned around_smaller(unsigned region) {
    return ((region & below) != 0 ? 1U : 0U) | ((region & same) != 0 ? 2U : 0U) |
           ((region & above) != 0 ? 28U : 0U);
}
unsigned around_larger(unsigned region) {
    return ((region & below) != 0 ? 7U : 0U) | ((region & same) != 0 ? 8U : 0U) |
           ((region & above) != 0 ? 16U : 0U);
}

bool contradict(const Program& program, Atom a, Atom b) {
    if (is_vacancy_test(a.operation) || is_vacancy_test(b.operation))
        return is_vacancy_test(a.operation) && is_vacancy_test(b.operation) && a.operation != b.operation &&
               same_expression(program, a.left, b.left);
    if (same_expression(program, a.left, b.right) && same_expression(program, a.right, b.left)) {
        std::swap(b.left, b.right);
        b.operation = mirrored(b.operation);
    }
    if (!same_expression(program, a.left, b.left)) return false;
    if (same_expression(program, a.right, b.right)) return (region(a.operation) & region(b.operation)) == 0;
    const auto* x = std::get_if<Literal>(&program.expressions[a.right].node);
    const auto* y = std::get_if<Literal>(&program.expressions[b.right].node);
    if (x == nullptr || y == nullptr) return false;
    if (x->value > y->value) std::swap(a, b);
    return (around_smaller(region(a.operation)) & around_larger(region(b.operation))) == 0;
}

/// What is left of the numbers that an expression can be, as far as whole numbers go.
struct WholeNumbers {
    double low = -semantics::infinity;
    double high = semantics::infinity;
    std::vector<double> excluded;

    void apply(Operation operation, double number) {
        switch (operation) {
        case Operation::less: high = std::min(high, std::ceil(number) - 1); break;
        case Operation::less_equal: high = std::min(high, std::floor(number)); break;
        case Operation::equal:
            low = std::max(low, number);
            high = std::min(high, number);
            break;
        case Operation::greater_equal: low = std::max(low, std::ceil(number)); break;
        case Operation::greater: low = std::max(low, std::floor(number) + 1); break;
        default: excluded.push_back(number); break;
        }
    }

    [[nodiscard]] bool none_left() const {
        if (low > high) return true;
        if (high - low >= static_cast<double>(excluded.size())) return false;
        for (double number = low; number <= high; ++number)
            if (std::ranges::find(excluded, number) == excluded.end()) return false;
        return true;
    }
};

bool is_bit(const Program& program, ExpressionId id) {
    const auto* load = std::get_if<LoadMachine>(&program.expressions[id].node);
    if (load == nullptr) return false;
    const VariableRange* range = program.control->families[load->family].find(load->number);
    return range != nullptr && range->is_bit;
}

/// Whether the comparisons of this expression with whole numbers leave it no whole number. Those who count
/// through the cases of a variable, #7EQ1, #7EQ2 …, mean whole numbers.
bool exhausted(const Program& program, const std::vector<Atom>& atoms, ExpressionId expression) {
    WholeNumbers left;
    if (is_bit(program, expression)) left = {0, 1, {}};
    for (const Atom& atom : atoms) {
        if (!is_comparison(atom.operation) || !same_expression(program, atom.left, expression)) continue;
        const auto* literal = std::get_if<Literal>(&program.expressions[atom.right].node);
        if (literal == nullptr) continue;
        if (std::floor(literal->value) != literal->value) return false;
        left.apply(atom.operation, literal->value);
    }
    return left.none_left();
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

std::optional<std::size_t> first_contradiction(const Program& program, std::span<const Decision> decisions) {
    constexpr std::size_t most_decisions = 256;
    std::vector<Atom> known;
    const std::size_t first = decisions.size() > most_decisions ? decisions.size() - most_decisions : 0;
    for (std::size_t i = first; i < decisions.size(); ++i) {
        std::vector<Atom> now;
        collect_atoms(program, decisions[i].condition, decisions[i].holds, now);
        for (const Atom& atom : now)
            for (const Atom& earlier : known)
                if (contradict(program, earlier, atom)) return i;
        known.insert(known.end(), now.begin(), now.end());
        for (const Atom& atom : now)
            if (exhausted(program, known, atom.left)) return i;
    }
    return std::nullopt;
}

} // namespace maclint::queries
