//! Interning of values, symbols, origins and modal values.
#include "analyzer/dataflow/value.hpp"

#include <bit>
#include <cmath>

namespace maclint::dataflow {
Pool::Pool() {
    symbols({Symbol::Kind::opaque, 0, 0, 0});
    origins({Origin::Kind::none, 0, 0});
}

void Pool::fit() {
    symbols.fit();
    origins.fit();
    values.fit();
    modals.fit();
    forgotten_sets.fit();
}

SymbolId Pool::constant(double number) {
    if (number == 0) number = 0; // no negative zero: it is the same number
    return symbols({Symbol::Kind::constant, std::bit_cast<std::uint64_t>(number), 0, 0});
}

std::optional<double> Pool::number_of(SymbolId symbol) const {
    const Symbol& s = symbols[symbol];
    return s.kind == Symbol::Kind::constant ? std::optional(std::bit_cast<double>(s.a)) : std::nullopt;
}

std::optional<GroupId> Pool::entry_group_of(SymbolId symbol) const {
    const Symbol& s = symbols[symbol];
    return s.kind == Symbol::Kind::entry_group ? std::optional(static_cast<GroupId>(s.a)) : std::nullopt;
}

Value number_value(Pool& pool, double number) { return number_value(pool.constant(number), number); }

Value number_value(SymbolId symbol, double number) {
    Value value;
    value.symbol = symbol;
    value.low = value.high = number;
    value.vacancy = Vacancy::set;
    value.exactness = Exactness::exact;
    value.integer = std::floor(number) == number;
    return value;
}

Value vacant_value(Pool& pool, OriginId doubt) {
    Value value;
    value.symbol = pool.symbols({Symbol::Kind::vacant, 0, 0, 0});
    value.low = value.high = 0; // what arithmetic and comparisons other than EQ and NE take it for
    value.vacancy = Vacancy::vacant;
    value.exactness = Exactness::exact;
    value.integer = true;
    value.doubt = doubt;
    return value;
}

} // namespace maclint::dataflow
