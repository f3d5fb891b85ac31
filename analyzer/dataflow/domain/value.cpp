//! Interning of values, symbols, origins and modal values.
#include "analyzer/dataflow/domain/value.hpp"

#include <bit>

namespace maclint::dataflow {
ValueTable::ValueTable() {
    symbols({Symbol::Kind::opaque, 0, 0, 0});
    origins({Origin::Kind::none, 0, 0});
}

void ValueTable::fit() {
    symbols.fit();
    origins.fit();
    values.fit();
    modals.fit();
    havoc_sets.fit();
}

SymbolId ValueTable::constant(double number) {
    if (number == 0) number = 0; // no negative zero: it is the same number
    return symbols({Symbol::Kind::constant, std::bit_cast<std::uint64_t>(number), 0, 0});
}

std::optional<double> ValueTable::number_of(SymbolId symbol) const {
    const Symbol& s = symbols[symbol];
    return s.kind == Symbol::Kind::constant ? std::optional(std::bit_cast<double>(s.a)) : std::nullopt;
}

SymbolId ValueTable::asked_for(SymbolId symbol) const {
    const Symbol& s = symbols[symbol];
    return s.kind == Symbol::Kind::if_set ? static_cast<SymbolId>(s.a) : symbol;
}

std::optional<GroupId> ValueTable::entry_group_of(SymbolId symbol) const {
    const Symbol& s = symbols[symbol];
    return s.kind == Symbol::Kind::entry_group ? std::optional(static_cast<GroupId>(s.a)) : std::nullopt;
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
    value.symbol = table.symbols({Symbol::Kind::vacant, 0, 0, 0});
    value.vacancy_origin = vacancy_origin;
    return value;
}

} // namespace maclint::dataflow
