//! Holds operations against what calls pass and against what the program compares.
#include "analyzer/queries/values/operand_risks.hpp"

#include "analyzer/dataflow/facts/clobber.hpp"
#include "analyzer/dataflow/facts/read.hpp"
#include "analyzer/dataflow/facts/store.hpp"
#include "analyzer/flow/walk.hpp"
#include "analyzer/program/tables.hpp"
#include "analyzer/queries/calls/callers.hpp"
#include "analyzer/queries/conditions/conditions.hpp"
#include "analyzer/queries/paths/exits.hpp"
#include "analyzer/semantics/concrete.hpp"
#include "analyzer/source/budget.hpp"
#include "analyzer/workspace/bind.hpp"

#include <algorithm>
#include <array>
#include <iterator>

namespace maclint::queries {
namespace {

using dataflow::Application;
using dataflow::Comparison;
using dataflow::Symbol;
using dataflow::Value;

/// Operands that are held against the checks before them.
constexpr int most_walks = 500;

bool contains(const std::vector<Variable>& variables, Variable variable) {
    return std::ranges::find(variables, variable) != variables.end();
}

void add(std::vector<Variable>& variables, const std::vector<Variable>& more) {
    for (const Variable variable : more)
        if (!contains(variables, variable)) variables.push_back(variable);
}

/// Whether the operation has no value for that operand.
bool fails(Operation operation, double operand) {
    const std::array<double, 2> both{1, operand};
    const auto operands = std::span<const double>(both);
    const bool is_binary = operation == Operation::divide;
    return std::holds_alternative<semantics::DomainError>(
        semantics::compute(operation, is_binary ? operands : operands.last(1)));
}

/// Whether what is known of the operand allows for that.
bool may_fail(Operation operation, const Value& operand) {
    switch (operation) {
    case Operation::divide: return operand.can_be(0);
    case Operation::logarithm: return operand.low <= 0;
    case Operation::square_root: return operand.low < 0;
    default: return operation == Operation::tangent || operand.low < -1 || operand.high > 1;
    }
}

Value value_of(dataflow::SymbolId symbol) {
    Value value;
    value.symbol = symbol;
    return value;
}

/// Of `90-#1` what makes it 90 when it is 0.
std::vector<Variable> right_angle_with(const ProgramAnalysis& analysis, const Value& operand,
                                       ZeroSources& zeros) {
    const auto& table = analysis.data().table();
    const Symbol& symbol = table.symbols[operand.symbol];
    if (symbol.kind() != Symbol::Kind::result ||
        (symbol.operation() != Operation::subtract && symbol.operation() != Operation::add))
        return {};
    for (const auto& [constant, other] :
         {std::pair(symbol.first(), symbol.second()), std::pair(symbol.second(), symbol.first())}) {
        const auto angle = table.number_of(constant);
        if (angle && fails(Operation::tangent, *angle)) return zeros.of(other);
    }
    return {};
}

/// The variables of both sides of a difference, where nothing else decides it.
std::vector<Variable> sides_of_difference(const ProgramAnalysis& analysis, const Value& operand) {
    const Symbol& symbol = analysis.data().table().symbols[operand.symbol];
    if (symbol.kind() != Symbol::Kind::result || symbol.operation() != Operation::subtract) return {};
    const GivenVariables left = given_variables(analysis, value_of(symbol.first()));
    const GivenVariables right = given_variables(analysis, value_of(symbol.second()));
    if (!left.closed || !right.closed || right.variables.empty()) return {};
    std::vector<Variable> both = left.variables;
    add(both, right.variables);
    return both;
}

/// The variables each of which leaves the operation without a value when it is 0.
std::vector<Variable> harmful_zeros(const ProgramAnalysis& analysis, Operation operation,
                                    const Value& operand, ZeroSources& zeros) {
    if (operation == Operation::tangent) return right_angle_with(analysis, operand, zeros);
    const bool takes_no_zero = operation == Operation::divide || operation == Operation::logarithm;
    return takes_no_zero ? zeros.of(operand.symbol) : std::vector<Variable>{};
}

/// Whether a caller, or a program that it calls, may store something in the variable.
bool is_set_by_others(const ProgramAnalysis& analysis, Variable variable) {
    return std::ranges::any_of(analysis.callers(), [&](const Caller& caller) {
        const dataflow::Facts& facts = calling_program(analysis, caller).facts();
        return !facts.about<dataflow::Store>(variable).empty() ||
               std::ranges::any_of(facts.all<dataflow::Clobber>(), [&](const dataflow::Clobber& clobber) {
                   return clobber.may_change(variable);
               });
    });
}

/// The nodes to which the program can come before it first comes to that one.
std::vector<bool> reached_without(const ProgramAnalysis& analysis, flow::NodeId node) {
    std::vector<bool> reached(analysis.graph().nodes.size(), false);
    reached[0] = node != 0;
    if (node == 0) return reached;
    flow::walk<flow::Direction::forward>(analysis.graph(), {0}, [&](flow::EdgeId edge, flow::NodeId to) {
        if (to == node || !analysis.data().passable(edge)) return flow::Step::refuse;
        reached[to] = true;
        return flow::Step::go_on;
    });
    return reached;
}

} // namespace

OperandRisks::OperandRisks(const ProgramAnalysis& analysis)
    : analysis_(analysis)
    , zeros_(analysis) {
    for (const Comparison& comparison : analysis.facts().all<Comparison>()) {
        const bool asks = semantics::is_vacancy_test(comparison.operation);
        const auto side = [&](ExpressionId expression) {
            const auto plain = plain_variable(analysis.program(), expression);
            return plain ? std::optional(dataflow::key_of(*plain)) : std::nullopt;
        };
        const std::pair sides(side(comparison.left_expression), side(comparison.right_expression));
        for (const auto& [value, expression] : {std::pair(&comparison.left, comparison.left_expression),
                                                std::pair(&comparison.right, comparison.right_expression)}) {
            auto variables = given_variables(analysis, *value).variables;
            if (asks) add(asked_, variables);
            if (!variables.empty() && (ends_in_alarm(analysis, comparison.node, true) ||
                                       ends_in_alarm(analysis, comparison.node, false)))
                add(guarded_, variables);
            if (const auto plain = plain_variable(analysis.program(), expression)) add(variables, {*plain});
            if (asks) continue;
            for (const Variable variable : variables) {
                Checks& checks = checks_[dataflow::key_of(variable)];
                checks.comparisons.push_back(&comparison);
                checks.sides.insert(sides);
            }
        }
    }
}

std::optional<OperandRisk> OperandRisks::risk_of(const Application& application) {
    constexpr int most_looks = 8; // the paths to the first few tell enough
    const Value& operand = application.right;
    if (!may_fail(application.operation, operand) || ++looks_[operand.symbol] > most_looks)
        return std::nullopt;
    if (const auto shown = shown_by_call(application)) return shown;
    if (application.operation == Operation::square_root) return risk_of_root(operand);
    const auto variables = harmful_zeros(analysis_, application.operation, operand, zeros_);
    if (variables.empty()) return std::nullopt;
    if (++walks_ > most_walks) {
        analysis_.search_memory().count(true);
        return std::nullopt;
    }
    const auto comes_first = reached_without(analysis_, application.node);
    for (const Variable variable : variables) {
        if (!may_be_anything(variable)) continue;
        const Comparison* passed = nullptr;
        const auto stops_zero = [&](const Comparison* comparison) {
            if (!comes_first[comparison->node]) return false;
            if (!lets_zero_pass(variable, *comparison)) return exemptions::compared_before.is_on();
            passed = comparison;
            return false;
        };
        const Checks* checks = checks_of(variable);
        if (checks != nullptr && std::ranges::any_of(checks->comparisons, stops_zero)) continue;
        if (passed != nullptr)
            return OperandRisk{OperandRisk::Evidence::lets_zero_pass, variable, nullptr, {}, passed};
        if (is_never_passed_as_zero(analysis_, variable)) continue;
        return unchecked(variable);
    }
    return std::nullopt;
}

/// The root of a difference: any comparison of one of its variables may keep it from being negative.
std::optional<OperandRisk> OperandRisks::risk_of_root(const Value& operand) const {
    const auto variables = sides_of_difference(analysis_, operand);
    const auto is_free = [&](Variable variable) {
        return may_be_anything(variable) &&
               (!exemptions::compared_before.is_on() || checks_of(variable) == nullptr);
    };
    if (variables.empty() || !std::ranges::all_of(variables, is_free)) return std::nullopt;
    return unchecked(variables.front());
}

std::optional<OperandRisk> OperandRisks::risk_of_argument(const dataflow::Read& read,
                                                          std::optional<Variable> counter) const {
    const Symbol& symbol = analysis_.data().table().symbols[read.value.symbol];
    const bool is_as_passed = symbol.is_entry_of(dataflow::key_of(read.variable));
    if (!is_as_passed || !analysis_.program().is_formal(read.variable) || analysis_.is_main() ||
        contains(asked_, read.variable) || is_checked(read.variable, counter))
        return std::nullopt;
    if (const Caller* caller = find_caller_without(analysis_, read.variable);
        caller != nullptr && is_on_every_path(analysis_, read.node))
        return OperandRisk{OperandRisk::Evidence::left_out, read.variable, caller, {}};
    if (!analysis_.callers().empty()) return std::nullopt;
    return unchecked(read.variable);
}

OperandRisk OperandRisks::unchecked(Variable variable) const {
    using Evidence = OperandRisk::Evidence;
    if (contains(asked_, variable)) return OperandRisk{Evidence::asked_vacancy, variable, nullptr, {}};
    if (const auto other = checked_beside(variable))
        return OperandRisk{Evidence::others_checked, variable, nullptr, other};
    return OperandRisk{Evidence::unchecked, variable, nullptr, {}};
}

std::optional<OperandRisk> OperandRisks::shown_by_call(const Application& application) const {
    const Value& operand = application.right;
    const GivenVariables given = given_variables(analysis_, operand);
    if (!given.closed || given.variables.empty()) return std::nullopt;
    const auto passed = value_for_a_call(analysis_, operand, [&](const PassedValue& value) {
        return fails(application.operation, value.number) && operand.can_be(value.number) &&
               !(value.left_out && contains(asked_, *value.left_out)); // such a call does not come here
    });
    if (!passed || !is_on_every_path(analysis_, application.node)) return std::nullopt;
    return OperandRisk{passed->left_out ? OperandRisk::Evidence::left_out : OperandRisk::Evidence::passed,
                       passed->left_out.value_or(given.variables.front()),
                       passed->call,
                       {}};
}

/// Whether the variable is compared with anything but the counter of a loop.
bool OperandRisks::is_checked(Variable variable, std::optional<Variable> counter) const {
    const Checks* checks = checks_of(variable);
    if (checks == nullptr || !counter) return checks != nullptr;
    const dataflow::Key key = dataflow::key_of(*counter);
    return std::ranges::any_of(checks->sides,
                               [&](const auto& sides) { return sides.first != key && sides.second != key; });
}

/// nullptr where nothing compares it.
const OperandRisks::Checks* OperandRisks::checks_of(Variable variable) const {
    const auto found = checks_.find(dataflow::key_of(variable));
    return found == checks_.end() ? nullptr : &found->second;
}

/// Whether the variable can be anything when the program begins.
bool OperandRisks::may_be_anything(Variable variable) const {
    if (analysis_.program().is_formal(variable)) return !analysis_.is_main();
    return analysis_.control().spaces[variable.space].scope == Scope::shared &&
           !is_set_by_others(analysis_, variable);
}

/// Whether it compares a value that is 0 where the variable is with a number, and ends in an alarm on the
/// other side than 0 takes.
bool OperandRisks::lets_zero_pass(Variable variable, const Comparison& comparison) {
    const auto limit = comparison.right.constant();
    if (!limit || !contains(zeros_.of(comparison.left.symbol), variable)) return false;
    const bool side_of_zero =
        semantics::compare(comparison.operation, 0.0, *limit, analysis_.control().vacant_equals_zero);
    return ends_in_alarm(analysis_, comparison.node, !side_of_zero);
}

std::optional<Variable> OperandRisks::checked_beside(Variable variable) const {
    const auto found = std::ranges::find_if(guarded_, [&](Variable other) {
        return !(other == variable) && analysis_.program().is_formal(other);
    });
    return found == guarded_.end() || !analysis_.program().is_formal(variable) ? std::nullopt
                                                                               : std::optional(*found);
}

} // namespace maclint::queries
