//! Expressions: their values, the truth of conditions, and what a condition tells about its variables.
#include "analyzer/dataflow/domain/read_set.hpp"
#include "analyzer/dataflow/solver/transfer.hpp"
#include "analyzer/program/overloaded.hpp"
#include "analyzer/program/tables.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

namespace maclint::dataflow {
namespace {

/// The operands of A OR B OR C: three, though what is written joins A OR B with C.
class Chain {
  public:
    Chain(const Program& program, Operation operation, std::span<const ExpressionId> operands)
        : operands_(operands) {
        const auto is_part = [&](ExpressionId operand) {
            return part(program, operation, operand) != nullptr;
        };
        if (std::ranges::none_of(operands, is_part)) return;
        collect(program, operation, operands);
        operands_ = all_;
    }
    Chain(const Chain&) = delete;
    Chain& operator=(const Chain&) = delete;
    [[nodiscard]] std::span<const ExpressionId> operands() const { return operands_; }

  private:
    static const Apply* part(const Program& program, Operation operation, ExpressionId id) {
        const auto* apply = std::get_if<Apply>(&program.expressions[id].node);
        return apply != nullptr && apply->operation == operation ? apply : nullptr;
    }
    void collect(const Program& program, Operation operation, std::span<const ExpressionId> operands) {
        for (const ExpressionId operand : operands)
            if (const Apply* apply = part(program, operation, operand))
                collect(program, operation, program.operands_of(*apply));
            else
                all_.push_back(operand);
    }

    std::span<const ExpressionId> operands_;
    std::vector<ExpressionId> all_; ///< empty: those of one application alone
};

} // namespace

Value Transfer::opaque(ExpressionId id) {
    Value value;
    value.symbol = states_.table().symbols(Symbol::of_expression(id, node_));
    return value;
}

Value Transfer::machine_value(FamilyId family, std::int32_t number, ExpressionId id) {
    Value value = opaque(id);
    const VariableRange* range = program_.control->families[family].find(number);
    if (range == nullptr) return value;
    if (!range->may_be_vacant) value.vacancy = Vacancy::set;
    if (range->last_number) {
        value.low = 0;
        value.high = *range->last_number;
        value.integer = true;
        value.exactness = Exactness::exact;
    }
    if (range->is_bit) {
        value.low = 0;
        value.high = 1;
        value.integer = true;
        value.exactness = Exactness::exact;
    }
    if (follows_one_path_) {
        // Inputs change by themselves, too. A program that asks for one twice takes it to stay as it is,
        // unless it waits for it.
        const bool awaited = std::ranges::find(awaited_, MachineValue{family, number}) != awaited_.end();
        const bool moves_on = range->changes_by_itself && (!range->is_bit || awaited);
        const bool stored = range->on_write == OnWrite::store;
        const std::uint64_t name = side_by_side(family, static_cast<std::uint32_t>(number));
        value.symbol = states_.table().symbols(
            Symbol::of_machine(name, moves_on ? machine_time_.acted : 0, stored ? machine_time_.stored : 0));
    }
    return value;
}

/// The same index means the same variable.
Value Transfer::indexed_value(FamilyId family, const Value& index, ExpressionId id) {
    constexpr std::uint32_t indexed = 1U << 16U;
    Value value = opaque(id);
    value.symbol = states_.table().symbols(Symbol::of_machine(side_by_side(family | indexed, index.symbol),
                                                              machine_time_.acted, machine_time_.stored));
    return value;
}

/// The value of a literal.
Value Transfer::number(ExpressionId id, double number) {
    SymbolId& known = constants_[id];
    if (known == 0) known = states_.table().constant(number);
    return number_value(known, number);
}

Value Transfer::record_read(const State& state, Variable variable, ExpressionId id, Use use) {
    const Value value = is_ambiguous(variable) ? opaque(id) : states_.read(state, variable);
    if (records<Read>()) facts_->add(Read{node_, effect_, id, variable, value, use});
    return value;
}

Value Transfer::load_modal(const State& state, GroupId group, ExpressionId id) {
    ModalValue modal = states_.read(state, channels_.running, group);
    modal.unknown |= channels_.uncertain != 0;
    if (records<ModalRead>()) facts_->add(ModalRead{node_, effect_, id, group, modal});
    Value value = opaque(id);
    value.vacancy = Vacancy::set;
    value.exactness = Exactness::exact;
    // Several paths that all leave the same code are one code.
    bool one = !modal.unknown && !modal.parts.empty();
    for (const ModalPart& part : modal.parts) one &= part.symbol == modal.parts.front().symbol;
    if (!one) return value;
    if (const auto code = states_.table().number_of(modal.parts.front().symbol))
        return number_value(states_.table(), *code);
    value.symbol = modal.parts.front().symbol;
    const auto channel = static_cast<std::uint8_t>(std::countr_zero(channels_.running));
    if (const auto code = states_.entry_code(state, {channel, group});
        code && states_.table().entry_group_of(value.symbol)) {
        value.low = value.high = *code;
    }
    return value;
}

Value Transfer::load_at(const State& state, FamilyId family, const Value& index, ExpressionId id, Use use) {
    const auto number = index.constant();
    if (!number || std::abs(*number) > 1e9) return opaque(id);
    const auto rounded = std::lround(*number); // a fraction is rounded [SINHA-INT]
    const VariableRange* range = program_.control->families[family].find(rounded);
    if (range == nullptr) return opaque(id);
    switch (range->meaning) {
    case Meaning::null: return vacant_value(states_.table(), 0);
    case Meaning::variable:
        return record_read(state, {range->space, static_cast<std::int32_t>(rounded)}, id, use);
    case Meaning::modal: return load_modal(state, range->group, id);
    default: return opaque(id);
    }
}

/// #[#31+10] with a vacant #31 is #10 only by a mistake that is reported at #31.
bool Transfer::rests_on_vacant(const State& state, ExpressionId index) {
    return std::ranges::any_of(variables_of(program_, index).variables, [&](Variable variable) {
        const Vacancy vacancy = states_.read(state, variable).vacancy;
        return vacancy == Vacancy::vacant || vacancy == Vacancy::maybe;
    });
}

Value Transfer::evaluate(const State& state, ExpressionId id, Use use) {
    ++evaluated_;
    const Expression& expression = program_.expressions[id];
    return std::visit(
        overloaded{
            [&](const Literal& literal) { return number(id, literal.value); },
            [&](const Vacant&) { return vacant_value(states_.table(), 0); },
            [&](const Load& load) { return record_read(state, load.variable, id, use); },
            [&](const LoadAt& load) {
                const Value index = evaluate(state, load.index, Use::index);
                if (rests_on_vacant(state, load.index)) return opaque(id);
                if (follows_one_path_ && !index.constant()) return indexed_value(load.family, index, id);
                return load_at(state, load.family, index, id, use);
            },
            [&](const LoadModal& load) { return load_modal(state, load.group, id); },
            [&](const LoadMachine& load) { return machine_value(load.family, load.number, id); },
            [&](const Apply& apply) {
                const auto operands = program_.operands_of(apply);
                constexpr std::size_t most = 4;
                std::array<Value, most> values;
                if (is_comparison(apply.operation) || apply.operation == Operation::is_vacant ||
                    apply.operation == Operation::is_set || operands.size() > most || operands.empty()) {
                    for (const ExpressionId operand : operands)
                        (void)evaluate(state, operand, Use::comparison);
                    return opaque(id);
                }
                for (std::size_t i = 0; i < operands.size(); ++i)
                    values[i] = evaluate(state, operands[i], Use::arithmetic);
                if (records<Application>() && semantics::may_have_no_value(apply.operation) &&
                    operands.size() <= 2)
                    facts_->add(Application{node_, effect_, id, apply.operation, operands.front(),
                                            operands.back(), values[0], values[operands.size() - 1]});
                return compute(states_.table(), apply.operation, std::span(values).first(operands.size()),
                               {Origin::Kind::expression, id, node_});
            },
            [&](const auto&) { return opaque(id); },
        },
        expression.node);
}

/// AND (`all`) or OR of conditions. Each condition is asked in the state that the ones before it leave: in
/// #1LT8 OR #1GT6 the second always holds where the first fails.
Truth Transfer::evaluate_chain(const State& state, std::span<const ExpressionId> operands, bool all) {
    const Chain chain(program_, all ? Operation::all_of : Operation::any_of, operands);
    Truth apart{all, !all};
    for (const ExpressionId operand : chain.operands()) {
        const Truth part = evaluate_condition(state, operand);
        apart.can_hold = all ? apart.can_hold && part.can_hold : apart.can_hold || part.can_hold;
        apart.can_fail = all ? apart.can_fail || part.can_fail : apart.can_fail && part.can_fail;
    }
    // A chain inside a chain is asked without that: otherwise each level of brackets would double the work.
    if (!(all ? apart.can_hold : apart.can_fail) || in_chain_) return apart;
    in_chain_ = true;
    FactLists* const facts = std::exchange(facts_, nullptr); // what is read is recorded already
    State agreed = state;
    for (const ExpressionId operand : chain.operands()) {
        const Truth part = evaluate_condition(agreed, operand);
        if (!(all ? part.can_hold : part.can_fail)) agreed.reached = false;
        if (agreed.reached) refine(agreed, operand, all);
        if (!agreed.reached) break;
    }
    in_chain_ = false;
    facts_ = facts;
    compared_.reset(); // of a state that only some paths lead to
    if (!agreed.reached) (all ? apart.can_hold : apart.can_fail) = false;
    return apart;
}

Truth Transfer::evaluate_condition(const State& state, ExpressionId id) {
    const auto* apply = std::get_if<Apply>(&program_.expressions[id].node);
    if (apply == nullptr) {
        (void)evaluate(state, id, Use::comparison);
        return {};
    }
    const auto operands = program_.operands_of(*apply);
    switch (apply->operation) {
    case Operation::all_of: return evaluate_chain(state, operands, true);
    case Operation::any_of: return evaluate_chain(state, operands, false);
    case Operation::not_of: return semantics::negated(evaluate_condition(state, operands.front()));
    case Operation::is_vacant:
    case Operation::is_set: {
        const Value value = evaluate(state, operands.front(), Use::vacancy_test);
        const Truth truth = semantics::test_vacancy(apply->operation, value);
        if (records<Comparison>())
            facts_->add(Comparison{node_, effect_, id, apply->operation, operands.front(), operands.front(),
                                   value, value, truth});
        return truth;
    }
    default: break;
    }
    if (!is_comparison(apply->operation) || operands.size() != 2) {
        (void)evaluate(state, id, Use::comparison);
        return {};
    }
    const Value left = evaluate(state, operands[0], Use::comparison);
    const Value right = evaluate(state, operands[1], Use::comparison);
    compared_ = {id, left, right};
    const Truth truth = compare(apply->operation, left, right, program_.control->vacant_equals_zero);
    if (records<Comparison>())
        facts_->add(
            Comparison{node_, effect_, id, apply->operation, operands[0], operands[1], left, right, truth});
    return truth;
}

void Transfer::refine(State& state, ExpressionId id, bool holds) {
    const auto* apply = std::get_if<Apply>(&program_.expressions[id].node);
    if (apply == nullptr) return;
    const auto operands = program_.operands_of(*apply);
    if (apply->operation == Operation::not_of) return refine(state, operands.front(), !holds);
    const bool all_hold = apply->operation == Operation::all_of && holds;
    const bool all_fail = apply->operation == Operation::any_of && !holds;
    if (all_hold || all_fail) {
        for (const ExpressionId operand : operands) refine(state, operand, holds);
        return;
    }
    if (apply->operation == Operation::all_of || apply->operation == Operation::any_of)
        return refine_to_one_of(state, id, holds);
    const Operation operation = holds ? apply->operation : opposite(apply->operation);
    if (operation == Operation::is_vacant || operation == Operation::is_set) {
        const auto* load = std::get_if<Load>(&program_.expressions[operands.front()].node);
        if (load != nullptr) refine_variable(state, load->variable, operation, {});
    } else if (is_comparison(operation) && operands.size() == 2) {
        if (!compared_ || compared_->expression != id)
            compared_ = {id, evaluate(state, operands[0], Use::comparison),
                         evaluate(state, operands[1], Use::comparison)};
        const auto [expression, left, right] = *compared_;
        refine_side(state, operands[0], left, operation, right);
        refine_side(state, operands[1], right, mirrored(operation), left);
    }
}

/// Gathers numbers, where the condition says that the variable is one of them: #1EQ1 OR #1EQ2. False where
/// the condition says something else.
bool Transfer::names_numbers(ExpressionId id, bool holds, NumbersNamed& named) const {
    const auto* apply = std::get_if<Apply>(&program_.expressions[id].node);
    if (apply == nullptr) return false;
    const auto operands = program_.operands_of(*apply);
    if (apply->operation == Operation::not_of) return names_numbers(operands.front(), !holds, named);
    if (apply->operation == (holds ? Operation::any_of : Operation::all_of))
        return std::ranges::all_of(
            operands, [&](ExpressionId operand) { return names_numbers(operand, holds, named); });
    if (apply->operation != (holds ? Operation::equal : Operation::not_equal) || operands.size() != 2)
        return false;
    const auto* load = std::get_if<Load>(&program_.expressions[operands[0]].node);
    const auto* literal = std::get_if<Literal>(&program_.expressions[operands[1]].node);
    if (load == nullptr || literal == nullptr) return false;
    // Where vacant equals 0, the variable may be vacant.
    if (literal->value == 0 && program_.control->vacant_equals_zero) return false;
    if (named.variable.value_or(load->variable) != load->variable) return false;
    named.variable = load->variable;
    named.numbers.push_back(literal->value);
    return true;
}

void Transfer::refine_to_one_of(State& state, ExpressionId id, bool holds) {
    NumbersNamed named;
    if (!names_numbers(id, holds, named) || named.numbers.size() > most_numbers_named) return;
    const Value before = states_.read(state, *named.variable);
    std::erase_if(named.numbers, [&](double number) { return !states_.table().can_be(before, number); });
    std::ranges::sort(named.numbers);
    const auto twice = std::ranges::unique(named.numbers);
    named.numbers.erase(twice.begin(), twice.end());
    if (named.numbers.empty()) {
        state.reached = false;
        return;
    }
    Value value = before;
    value.vacancy = Vacancy::set;
    value.vacancy_origin = 0;
    value.exactness = Exactness::exact;
    states_.table().narrow(value, named.numbers);
    states_.write(state, *named.variable, value);
}

/// What is learnt of one side of a comparison, whose value is `value`.
void Transfer::refine_side(State& state, ExpressionId side, const Value& value, Operation operation,
                           Value other) {
    const Expression& expression = program_.expressions[side];
    if (std::holds_alternative<LoadModal>(expression.node)) {
        refine_entry_code(state, value, operation, other);
    } else if (const auto* load = std::get_if<Load>(&expression.node)) {
        refine_entry_code(state, value, operation, other);
        refine_variable(state, load->variable, operation, other);
    } else if (const auto* apply = std::get_if<Apply>(&expression.node);
               apply != nullptr && apply->operation == Operation::multiply) {
        const bool excludes = operation == Operation::not_equal || operation == Operation::less ||
                              operation == Operation::greater;
        if (excludes && other.constant() == 0 && other.vacancy == Vacancy::set)
            refine_factors(state, side, other);
    } else if (apply != nullptr && apply->operation == Operation::negate) {
        const auto* negated =
            std::get_if<Load>(&program_.expressions[program_.operands_of(*apply).front()].node);
        // EQ and NE tell vacant from 0, and what is negated is a number.
        const bool tells_vacant = operation == Operation::not_equal && other.vacancy != Vacancy::set;
        if (negated == nullptr || operation == Operation::equal || tells_vacant) return;
        other = compute(states_.table(), Operation::negate, std::span(&other, 1),
                        {Origin::Kind::expression, side, node_});
        refine_variable(state, negated->variable, mirrored(operation), other);
    }
}

/// The product is not 0: neither is a factor, nor vacant, which counts as 0 in it.
void Transfer::refine_factors(State& state, ExpressionId factor, const Value& zero) {
    const Expression& expression = program_.expressions[factor];
    if (const auto* load = std::get_if<Load>(&expression.node)) {
        refine_variable(state, load->variable, Operation::is_set, {});
        if (state.reached) refine_variable(state, load->variable, Operation::not_equal, zero);
    } else if (const auto* apply = std::get_if<Apply>(&expression.node);
               apply != nullptr && apply->operation == Operation::multiply) {
        for (const ExpressionId each : program_.operands_of(*apply))
            if (state.reached) refine_factors(state, each, zero);
    }
}

void Transfer::refine_entry_code(State& state, const Value& value, Operation operation, const Value& other) {
    const auto group = states_.table().entry_group_of(value.symbol);
    const auto code = other.constant();
    if (!group || !code) return;
    const auto know = [&](double known) {
        for_each_channel(channels_.running, [&](std::uint8_t channel) {
            know_entry_code(state, {channel, *group}, known);
        });
    };
    if (operation == Operation::equal) know(*code);
    const auto& members = program_.control->groups[*group].members;
    if (operation == Operation::not_equal && members.size() == 2 &&
        (members[0].number == *code || members[1].number == *code))
        know(members[0].number == *code ? members[1].number : members[0].number);
}

/// It is known here that the caller's code is this one: where the program has set it, it has set the
/// caller's.
void Transfer::know_entry_code(State& state, ChannelGroup of, double code) {
    states_.know_entry_code(state, of, code);
    ModalValue value = states_.read(state, of);
    for (ModalPart& part : value.parts)
        if (states_.table().number_of(part.symbol) == code)
            part.symbol = states_.table().symbols(Symbol::group_at_entry(of.group));
    value.put_in_order();
    states_.write(state, of, std::move(value));
}

/// Keeps those numbers that the value can be for which the comparison can be true; false when none is left.
bool Transfer::keep_choices(Value& value, Operation operation, const Value& other) {
    std::vector<double> left;
    for (const double number : states_.table().choices_of(value))
        if (semantics::compare(operation, semantics::of_number(number), other,
                               program_.control->vacant_equals_zero)
                .can_hold)
            left.push_back(number);
    if (!left.empty()) states_.table().narrow(value, left);
    return !left.empty();
}

void Transfer::refine_variable(State& state, Variable variable, Operation operation, const Value& other) {
    const Value before = states_.read(state, variable);
    Value value = before;
    if (operation == Operation::is_vacant) {
        if (value.vacancy == Vacancy::set) return;
        value = vacant_value(states_.table(), before.vacancy_origin);
        value.origin = before.origin;
    } else if (operation == Operation::is_set) {
        value.vacancy = Vacancy::set;
    } else {
        const auto left = semantics::refine(before, operation, other, program_.control->vacant_equals_zero);
        if (!left) {
            state.reached = false;
            return;
        }
        value.know(*left);
        if (value.choices != 0 && !keep_choices(value, operation, other)) {
            state.reached = false;
            return;
        }
        if (value.low == value.high && value.vacancy == Vacancy::set && operation == Operation::equal &&
            other.constant()) {
            value = number_value(states_.table(), value.low);
            value.origin = before.origin;
            // A saved copy of the caller's code stays one.
            if (states_.table().entry_group_of(before.symbol)) value.symbol = before.symbol;
        }
    }
    if (value.vacancy == Vacancy::set && before.vacancy != Vacancy::set) value.vacancy_origin = 0;
    if (!(value == before)) states_.write(state, variable, value);
}

} // namespace maclint::dataflow
