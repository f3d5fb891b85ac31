//! Interning of values, symbols, origins and modal values.
#include "analyzer/dataflow/value.hpp"

#include <bit>
#include <cmath>
#include <functional>

namespace maclint::dataflow {
namespace {

void mix(std::size_t& hash, std::uint64_t value) {
    // The finaliser of splitmix64: cheap, and every bit of the input reaches every bit of the result.
    value += 0x9E3779B97F4A7C15ULL + hash;
    value = (value ^ (value >> 30U)) * 0xBF58476D1CE4E5B9ULL;
    value = (value ^ (value >> 27U)) * 0x94D049BB133111EBULL;
    hash = static_cast<std::size_t>(value ^ (value >> 31U));
}

} // namespace

std::size_t HashValue::operator()(const Value& v) const {
    std::size_t hash = 0;
    mix(hash, (std::uint64_t{v.symbol} << 32U) | v.origin);
    mix(hash, (std::uint64_t{v.doubt} << 32U) | v.rounding);
    mix(hash, std::bit_cast<std::uint64_t>(v.low));
    mix(hash, std::bit_cast<std::uint64_t>(v.high));
    mix(hash, (static_cast<std::uint64_t>(v.vacancy) << 16U) |
                  (static_cast<std::uint64_t>(v.exactness) << 8U) | (v.integer ? 1U : 0U) |
                  (v.nonzero ? 2U : 0U));
    return hash;
}

std::size_t HashSymbol::operator()(const Symbol& s) const {
    std::size_t hash = 0;
    mix(hash, static_cast<std::uint64_t>(s.kind));
    mix(hash, s.a);
    mix(hash, (std::uint64_t{s.b} << 32U) | s.c);
    return hash;
}

std::size_t HashOrigin::operator()(const Origin& o) const {
    std::size_t hash = 0;
    mix(hash, (static_cast<std::uint64_t>(o.kind) << 32U) | o.id);
    mix(hash, o.node);
    return hash;
}

std::size_t HashModal::operator()(const ModalValue& v) const {
    std::size_t hash = v.unknown ? 1 : 0;
    for (const ModalPart& part : v.parts) mix(hash, (std::uint64_t{part.symbol} << 32U) | part.origin);
    return hash;
}

Pool::Pool() {
    symbols({Symbol::Kind::opaque, 0, 0, 0});
    origins({Origin::Kind::none, 0, 0});
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

Value number_value(Pool& pool, double number) {
    Value value;
    value.symbol = pool.constant(number);
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
