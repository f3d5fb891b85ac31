//! Numbers in calculations, and in the arguments of calls.
#include "rules/variables/bare_number_for_variable_calculations_finder.hpp"

#include "analyzer/program/indices.hpp"
#include "analyzer/program/tables.hpp"
#include "analyzer/semantics/concrete.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <set>
#include <string_view>
#include <variant>

namespace maclint::rules {
namespace {

/// Brackets around nothing but a variable, or a number with a point, that is calculated with: who writes them
/// may put any number in brackets.
bool brackets_single_values(const Program& program) {
    return std::ranges::any_of(program.expressions, [&](const Expression& expression) {
        const auto* apply = std::get_if<Apply>(&expression.node);
        if (apply == nullptr || !is_basic_arithmetic(apply->operation)) return false;
        return std::ranges::any_of(program.operands_of(*apply), [&](ExpressionId id) {
            const auto& node = program.expressions[id].node;
            const auto* literal = std::get_if<Literal>(&node);
            const bool is_single = std::holds_alternative<Load>(node) ||
                                   (literal != nullptr && !number_of_a_variable(program, id));
            return is_single && program.slice(program.expressions[id].span).starts_with('[');
        });
    });
}

/// `[#4+1]*[6]` where the program reads #6, which K passes.
void find_in_brackets_of_calculations(const Program& program, std::vector<BareNumber>& found) {
    if (brackets_single_values(program)) return;
    for (const Expression& expression : program.expressions) {
        const auto* apply = std::get_if<Apply>(&expression.node);
        if (apply == nullptr || !is_basic_arithmetic(apply->operation)) continue;
        for (const ExpressionId operand : program.operands_of(*apply)) {
            const Span span = program.expressions[operand].span;
            const auto number = number_of_a_variable(program, operand);
            if (!number || !program.slice(span).starts_with('[')) continue;
            const bool is_passed = std::ranges::any_of(
                program.control->formals, [&](Variable formal) { return formal.number == number; });
            if (is_passed && names_variable(program, *number)) found.push_back({*number, span, {}});
        }
    }
}

/// The variables that conditions ask for being there, by their reads.
std::set<ExpressionId> vacancy_tests(const Program& program) {
    std::set<ExpressionId> reads;
    for (const Expression& expression : program.expressions) {
        const auto* test = std::get_if<Apply>(&expression.node);
        if (test != nullptr &&
            (test->operation == Operation::is_vacant || test->operation == Operation::is_set))
            reads.insert(program.operands_of(*test).front());
    }
    return reads;
}

/// Adds the numbers of arguments that these reads take, and takes out those of variables that others take.
void take_arguments(const Program& program, const std::set<ExpressionId>& reads,
                    std::set<std::int64_t>& numbers) {
    for (const ExpressionId id : reads)
        if (const auto* load = std::get_if<Load>(&program.expressions[id].node))
            if (program.is_formal(load->variable)) numbers.insert(load->variable.number);
    for (ExpressionId id = 0; id < program.expressions.size(); ++id)
        if (const auto* load = std::get_if<Load>(&program.expressions[id].node); load && !reads.contains(id))
            numbers.erase(load->variable.number);
}

/// The numbers of variables that the program sets, or asks for as arguments, and never reads. Whether they
/// are there it may ask.
std::set<std::int64_t> numbers_in_vain(const Program& program) {
    const std::set<ExpressionId> tests = vacancy_tests(program);
    std::set<std::int64_t> numbers;
    for (const Effect& effect : program.effects)
        if (const auto* assign = std::get_if<Assign>(&effect.what))
            if (const auto* target = std::get_if<Variable>(&assign->target))
                if (!program.is_formal(*target)) numbers.insert(target->number);
    take_arguments(program, tests, numbers);
    return numbers;
}

/// The numbers of arguments that the program compares, or asks for being there, and does nothing else with.
std::set<std::int64_t> numbers_only_asked(const Program& program) {
    std::set<ExpressionId> asked = vacancy_tests(program);
    for (const Expression& expression : program.expressions) {
        const auto* test = std::get_if<Apply>(&expression.node);
        if (test != nullptr && semantics::is_comparison(test->operation))
            for (const ExpressionId operand : program.operands_of(*test)) asked.insert(operand);
    }
    std::set<std::int64_t> numbers;
    take_arguments(program, asked, numbers);
    return numbers;
}

/// Marks the expression and its operands.
void mark(const Program& program, ExpressionId id, std::vector<bool>& marked) {
    marked[id] = true;
    if (const auto* apply = std::get_if<Apply>(&program.expressions[id].node))
        for (const ExpressionId operand : program.operands_of(*apply)) mark(program, operand, marked);
}

/// Those in brackets that name a variable by its number.
std::vector<bool> indexes(const Program& program) {
    std::vector<bool> marked(program.expressions.size(), false);
    for_each_index(program, [&](ExpressionId index) { mark(program, index, marked); });
    return marked;
}

/// `A549` in a call, where #549 is the program's and nothing in it reads that.
void find_in_arguments(const Program& program, const std::set<std::int64_t>& in_vain,
                       std::vector<BareNumber>& found) {
    constexpr std::int64_t first_common = 100;
    for (const Argument& argument : program.arguments) {
        const auto number = number_of_a_variable(program, argument.value);
        if (number && *number >= first_common && in_vain.contains(*number) &&
            is_like_a_variable(program, *number))
            found.push_back({*number, argument.span, {}, true});
    }
}

/// `#101=101+1`: no variable is set to a sum of numbers, and its own among them.
void find_own_numbers(const Program& program, std::vector<BareNumber>& found) {
    for (const Effect& effect : program.effects) {
        const auto* assign = std::get_if<Assign>(&effect.what);
        const auto* target = assign == nullptr ? nullptr : std::get_if<Variable>(&assign->target);
        const auto* sum =
            target == nullptr ? nullptr : std::get_if<Apply>(&program.expressions[assign->value].node);
        if (sum == nullptr || (sum->operation != Operation::add && sum->operation != Operation::subtract))
            continue;
        const auto operands = program.operands_of(*sum);
        const auto number = number_of_a_variable(program, operands[0]);
        if (number == target->number &&
            std::holds_alternative<Literal>(program.expressions[operands[1]].node))
            found.push_back({*number, program.expressions[operands[0]].span, effect.span});
    }
}

/// `#30=517*2` where the program sets #517, and nothing in it reads that; `S[3800/19]` where it only checks
/// #19, and no variable stands in the calculation.
void find_in_calculations(const Program& program, const std::set<std::int64_t>& in_vain,
                          std::vector<BareNumber>& found) {
    const std::set<std::int64_t> only_asked = numbers_only_asked(program);
    if (in_vain.empty() && only_asked.empty()) return;
    const std::vector<bool> is_index = indexes(program);
    for (ExpressionId id = 0; id < program.expressions.size(); ++id) {
        const auto* apply = std::get_if<Apply>(&program.expressions[id].node);
        if (apply == nullptr || is_index[id] || !is_basic_arithmetic(apply->operation)) continue;
        const auto operands = program.operands_of(*apply);
        const bool of_numbers = is_of_numbers(program, *apply);
        for (const ExpressionId operand : operands) {
            const auto number = number_of_a_variable(program, operand);
            const Span span = program.expressions[operand].span;
            if (number && (in_vain.contains(*number) || (of_numbers && only_asked.contains(*number))) &&
                is_like_a_variable(program, *number) && !program.slice(span).starts_with('['))
                found.push_back({*number, span, {}, true});
        }
    }
}

} // namespace

bool is_basic_arithmetic(Operation operation) {
    return operation == Operation::add || operation == Operation::subtract ||
           operation == Operation::multiply || operation == Operation::divide;
}

bool is_of_numbers(const Program& program, const Apply& apply) {
    return is_basic_arithmetic(apply.operation) &&
           std::ranges::all_of(program.operands_of(apply), [&](ExpressionId operand) {
               return std::holds_alternative<Literal>(program.expressions[operand].node);
           });
}

bool is_like_a_variable(const Program& program, std::int64_t number) {
    constexpr std::int64_t first_common = 100, round = 10;
    if (number % round == 0) return false;
    return number >= first_common || std::ranges::any_of(program.control->formals, [&](Variable formal) {
               return formal.number == number && number > round;
           });
}

void find_in_calculations(const Program& program, std::vector<BareNumber>& found) {
    find_in_brackets_of_calculations(program, found);
    const std::set<std::int64_t> in_vain = numbers_in_vain(program);
    find_in_calculations(program, in_vain, found);
    find_in_arguments(program, in_vain, found);
    find_own_numbers(program, found);
}

} // namespace maclint::rules
