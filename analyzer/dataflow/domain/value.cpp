//! Interning of values, symbols, origins and modal values.
#include "analyzer/dataflow/domain/value.hpp"

#include <algorithm>
#include <bit>

namespace maclint::dataflow {
namespace {

/// A value that can be more numbers than this counts as one that can be any.
constexpr std::size_t most_choices = 8;

void add(Choices& choices, double number) {
    const auto position = std::ranges::lower_bound(choices.numbers, number);
    if (position == choices.numbers.end() || *position != number) choices.numbers.insert(position, number);
}

} // namespace

void ModalValue::put_in_order() {
    std::ranges::sort(parts);
    parts.cut_off(std::ranges::unique(parts).begin());
}

bool ModalValue::includes(const ModalValue& other) const {
    return (unknown || !other.unknown) && std::ranges::includes(parts, other.parts);
}

ValueTable::ValueTable() {
    symbols(Symbol::opaque());
    origins({Origin::Kind::none, 0, 0});
}

HavocId ValueTable::remember(const HavocSet& havoc) { return havoc_sets(havoc) + 1; }

void ValueTable::fit() {
    symbols.fit();
    origins.fit();
    values.fit();
    modals.fit();
    havoc_sets.fit();
    choice_sets.fit();
}

std::span<const double> ValueTable::choices_of(const Value& value) const {
    if (value.choices == 0) return {};
    const auto& numbers = choice_sets[value.choices - 1].numbers;
    return {numbers.begin(), numbers.size()};
}

bool ValueTable::can_be(const Value& value, double number) const {
    const auto choices = choices_of(value);
    return value.can_be(number) && (choices.empty() || std::ranges::binary_search(choices, number));
}

ChoicesId ValueTable::either(const Value& a, const Value& b) {
    Choices both;
    for (const Value* value : {&a, &b}) {
        const auto number = value->constant();
        const auto choices = choices_of(*value);
        if (!number && choices.empty()) return 0;
        if (number) add(both, *number);
        for (const double choice : choices) add(both, choice);
    }
    if (both.numbers.size() < 2 || both.numbers.size() > most_choices) return 0;
    return choice_sets(both) + 1;
}

void ValueTable::narrow(Value& value, std::span<const double> numbers) {
    // A value that may be vacant counts as 0. When only 0 is left, it is still not known to be a number.
    const bool is_number = numbers.front() != 0 || value.vacancy == Vacancy::set;
    if (numbers.size() == 1 && is_number) {
        const OriginId origin = value.origin;
        value = number_value(*this, numbers.front());
        value.origin = origin;
        return;
    }
    Choices left;
    for (const double number : numbers) add(left, number);
    value.choices = numbers.size() == 1 ? 0 : choice_sets(left) + 1;
    value.low = numbers.front();
    value.high = numbers.back();
}

SymbolId ValueTable::constant(double number) {
    if (number == 0) number = 0; // no negative zero: it is the same number
    return symbols(Symbol::of_number(number));
}

std::optional<double> ValueTable::number_of(SymbolId symbol) const {
    const Symbol& s = symbols[symbol];
    return s.kind() == Symbol::Kind::constant ? std::optional(s.number()) : std::nullopt;
}

SymbolId ValueTable::asked_for(SymbolId symbol) const {
    const Symbol& s = symbols[symbol];
    return s.kind() == Symbol::Kind::if_set ? s.word_value() : symbol;
}

std::optional<GroupId> ValueTable::entry_group_of(SymbolId symbol) const {
    const Symbol& s = symbols[symbol];
    return s.kind() == Symbol::Kind::entry_group ? std::optional(s.group()) : std::nullopt;
}

Value number_value(ValueTable& table, double number) { return number_value(table.constant(number), number); }

Value number_value(SymbolId symbol, double number) {
    Value value;
    value.know(semantics::of_number(number));
    value.symbol = symbol;
    return value;
}

Value vacant_value(ValueTable& table, OriginId vacancy_origin) {
    Value value;
    value.know(semantics::of_vacant());
    value.symbol = table.symbols(Symbol::of_vacancy());
    value.vacancy_origin = vacancy_origin;
    return value;
}

} // namespace maclint::dataflow
