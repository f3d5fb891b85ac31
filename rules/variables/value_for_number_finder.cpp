//! Looks into the indices of a program.
#include "rules/variables/value_for_number_finder.hpp"

#include "analyzer/dataflow/domain/read_set.hpp"
#include "analyzer/program/indices.hpp"
#include "analyzer/program/tables.hpp"
#include "analyzer/program/whole_number.hpp"
#include "analyzer/semantics/concrete.hpp"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <set>
#include <utility>
#include <variant>

namespace maclint::rules {
namespace {

bool is_kept_by_the_machine(const Program& program, ExpressionId id) {
    const auto* load = std::get_if<LoadMachine>(&program.expressions[id].node);
    const VariableRange* range =
        load == nullptr ? nullptr : program.control->families[load->family].find(load->number);
    return range != nullptr && range->on_write == OnWrite::store && !range->changes_by_itself &&
           !range->is_bit;
}

bool is_variable(const Program& program, ExpressionId id) {
    return std::holds_alternative<Load>(program.expressions[id].node);
}

/// The value in a sum of it and a variable.
std::optional<ExpressionId> value_in(const Program& program, ExpressionId index) {
    const auto* sum = std::get_if<Apply>(&program.expressions[index].node);
    if (sum == nullptr || sum->operation != Operation::add) return std::nullopt;
    const auto operands = program.operands_of(*sum);
    if (is_kept_by_the_machine(program, operands[0]) && is_variable(program, operands[1])) return operands[0];
    if (is_kept_by_the_machine(program, operands[1]) && is_variable(program, operands[0])) return operands[1];
    return std::nullopt;
}

/// The local variable whose number a literal is.
std::optional<Variable> local_of(const Program& program, FamilyId family, ExpressionId number) {
    const auto* literal = std::get_if<Literal>(&program.expressions[number].node);
    const auto whole = literal == nullptr ? std::nullopt : whole_number(literal->value);
    const VariableRange* range = whole ? program.control->families[family].find(*whole) : nullptr;
    if (range == nullptr || range->meaning != Meaning::variable ||
        program.control->spaces[range->space].scope != Scope::frame)
        return std::nullopt;
    return Variable{range->space, static_cast<std::int32_t>(*whole)};
}

std::optional<NumberForValue> number_in(const Program& program, const LoadAt& load) {
    const auto* difference = std::get_if<Apply>(&program.expressions[load.index].node);
    if (difference == nullptr || difference->operation != Operation::subtract) return std::nullopt;
    const auto operands = program.operands_of(*difference);
    const auto first = local_of(program, load.family, operands[0]);
    const auto* second = std::get_if<Load>(&program.expressions[operands[1]].node);
    if (!first || second == nullptr || second->variable.space != first->space) return std::nullopt;
    return NumberForValue{load.index, *first, operands[1]};
}

/// Whether a number of a local variable stands in the index, other than in such a difference.
bool reaches_locals(const Program& program, FamilyId family, ExpressionId index) {
    if (local_of(program, family, index)) return true;
    const auto* apply = std::get_if<Apply>(&program.expressions[index].node);
    return apply != nullptr && std::ranges::any_of(program.operands_of(*apply), [&](ExpressionId operand) {
               return reaches_locals(program, family, operand);
           });
}

bool uses_locals_as_list(const Program& program) {
    const auto reaches = [&](FamilyId family, ExpressionId index) {
        return reaches_locals(program, family, index);
    };
    return std::ranges::any_of(program.expressions,
                               [&](const Expression& expression) {
                                   const auto* load = std::get_if<LoadAt>(&expression.node);
                                   return load != nullptr && !number_in(program, *load) &&
                                          reaches(load->family, load->index);
                               }) ||
           std::ranges::any_of(program.effects, [&](const Effect& effect) {
               const auto* assign = std::get_if<Assign>(&effect.what);
               const auto* store = assign == nullptr ? nullptr : std::get_if<StoreAt>(&assign->target);
               return store != nullptr && reaches(store->family, store->index);
           });
}

bool reads(const Program& program, Variable variable) {
    return std::ranges::any_of(program.expressions, [&](const Expression& expression) {
        const auto* load = std::get_if<Load>(&expression.node);
        return load != nullptr && load->variable == variable;
    });
}

/// The indexed variable that a word is, its sign aside.
const LoadAt* indexed(const Program& program, ExpressionId id) {
    const auto* apply = std::get_if<Apply>(&program.expressions[id].node);
    if (apply != nullptr && apply->operation == Operation::negate)
        return indexed(program, program.operands_of(*apply).front());
    return std::get_if<LoadAt>(&program.expressions[id].node);
}

/// The variables that are all of an index.
std::set<std::pair<SpaceId, std::int32_t>> variables_of_indexes(const Program& program) {
    std::set<std::pair<SpaceId, std::int32_t>> found;
    for_each_index(program, [&](ExpressionId index) {
        if (const auto* load = std::get_if<Load>(&program.expressions[index].node))
            found.emplace(load->variable.space, load->variable.number);
    });
    return found;
}

/// Whether the only value that the program gives the variable is the sum of a number and something else.
bool holds_a_number_only(const Program& program, Variable variable) {
    constexpr double first_common = 100;
    int sums = 0;
    for (const Effect& effect : program.effects) {
        const auto* assign = std::get_if<Assign>(&effect.what);
        const auto* target = assign == nullptr ? nullptr : std::get_if<Variable>(&assign->target);
        if (target == nullptr || !(*target == variable)) continue;
        const auto* sum = std::get_if<Apply>(&program.expressions[assign->value].node);
        if (sum == nullptr || sum->operation != Operation::add) return false;
        const auto operands = program.operands_of(*sum);
        const bool has_base = std::ranges::any_of(operands, [&](ExpressionId operand) {
            const auto* literal = std::get_if<Literal>(&program.expressions[operand].node);
            return literal != nullptr && literal->value >= first_common && !literal->decimal_point;
        });
        if (!has_base) return false;
        ++sums;
    }
    return sums == 1;
}

/// Whether the other stands in what the program stores in the variable.
bool is_made_of(const Program& program, Variable variable, Variable other) {
    return std::ranges::any_of(program.effects, [&](const Effect& effect) {
        const auto* assign = std::get_if<Assign>(&effect.what);
        const auto* target = assign == nullptr ? nullptr : std::get_if<Variable>(&assign->target);
        if (target == nullptr || !(*target == variable)) return false;
        const auto read = dataflow::variables_of(program, assign->value).variables;
        return std::ranges::find(read, other) != read.end();
    });
}

/// The variable in the sum; nothing where it has none of the wanted.
template<class Wanted>
std::optional<ExpressionId> summand_of(const Program& program, ExpressionId id, const Wanted& wanted) {
    if (wanted(id)) return id;
    const auto* sum = std::get_if<Apply>(&program.expressions[id].node);
    if (sum == nullptr || sum->operation != Operation::add) return std::nullopt;
    for (const ExpressionId operand : program.operands_of(*sum))
        if (const auto found = summand_of(program, operand, wanted)) return found;
    return std::nullopt;
}

} // namespace

std::vector<ExpressionId> find_numbers_stored(const Program& program) {
    std::vector<ExpressionId> found;
    const auto indexes = variables_of_indexes(program);
    if (indexes.empty()) return found;
    const auto is_number = [&](ExpressionId id) {
        const auto* load = std::get_if<Load>(&program.expressions[id].node);
        return load != nullptr && indexes.contains({load->variable.space, load->variable.number}) &&
               holds_a_number_only(program, load->variable);
    };
    for (const Effect& effect : program.effects) {
        const auto* assign = std::get_if<Assign>(&effect.what);
        if (assign == nullptr || !std::holds_alternative<StoreAt>(assign->target) ||
            is_number(assign->value)) // a list of numbers
            continue;
        if (const auto number = summand_of(program, assign->value, is_number)) found.push_back(*number);
    }
    return found;
}

std::vector<NumberAgainstLimit> find_numbers_against_limits(const Program& program) {
    std::vector<NumberAgainstLimit> found;
    const auto indexes = variables_of_indexes(program);
    if (indexes.empty()) return found;
    const auto is_index = [&](Variable variable) {
        return indexes.contains({variable.space, variable.number});
    };
    for (ExpressionId id = 0; id < program.expressions.size(); ++id) {
        const auto* apply = std::get_if<Apply>(&program.expressions[id].node);
        if (apply == nullptr || !semantics::is_order(apply->operation)) continue;
        const auto operands = program.operands_of(*apply);
        const auto* number = std::get_if<Load>(&program.expressions[operands[0]].node);
        const auto* limit = std::get_if<Load>(&program.expressions[operands[1]].node);
        if (number != nullptr && limit != nullptr && is_index(number->variable) &&
            !is_index(limit->variable) && program.is_formal(limit->variable) &&
            holds_a_number_only(program, number->variable) &&
            !is_made_of(program, number->variable, limit->variable))
            found.push_back({id, operands[0], operands[1]});
    }
    return found;
}

std::vector<ExpressionId> find_numbers_compared(const Program& program) {
    std::vector<ExpressionId> found;
    const auto indexes = variables_of_indexes(program);
    if (indexes.empty()) return found;
    const auto is_index = [&](ExpressionId id) {
        const auto* load = std::get_if<Load>(&program.expressions[id].node);
        return load != nullptr && indexes.contains({load->variable.space, load->variable.number});
    };
    const auto is_number = [&](ExpressionId id) {
        const auto* load = std::get_if<Load>(&program.expressions[id].node);
        return load != nullptr && holds_a_number_only(program, load->variable);
    };
    for (ExpressionId id = 0; id < program.expressions.size(); ++id) {
        const auto* apply = std::get_if<Apply>(&program.expressions[id].node);
        if (apply == nullptr || !semantics::is_comparison(apply->operation)) continue;
        const auto operands = program.operands_of(*apply);
        if (std::ranges::any_of(operands, is_index) && std::ranges::all_of(operands, is_number))
            found.push_back(id);
    }
    return found;
}

std::vector<NumberForValue> find_numbers_for_values(const Program& program) {
    std::vector<NumberForValue> found;
    for (const Effect& effect : program.effects) {
        const auto* words = std::get_if<EvaluateWords>(&effect.what);
        if (words == nullptr) continue;
        for (const ExpressionId value : program.values_of(*words)) {
            const LoadAt* load = indexed(program, value);
            const auto number = load == nullptr ? std::nullopt : number_in(program, *load);
            if (number && reads(program, number->first)) found.push_back(*number);
        }
    }
    if (!found.empty() && uses_locals_as_list(program)) found.clear();
    return found;
}

std::vector<ValueForNumber> find_values_for_numbers(const Program& program) {
    std::vector<ValueForNumber> found;
    for_each_index(program, [&](ExpressionId index) {
        if (const auto value = value_in(program, index)) found.push_back({index, *value});
    });
    return found;
}

} // namespace maclint::rules
