//! Which computation a result is, and where its vacancy and its rounding come from.
#include "analyzer/dataflow/domain/arithmetic.hpp"

#include <algorithm>
#include <utility>

namespace maclint::dataflow {
namespace {

OriginId vacancy_origin_of(std::span<const Value> v) {
    const auto doubtful = std::ranges::find_if(
        v, [](const Value& value) { return value.vacancy_origin != 0 && value.can_be(0); });
    return doubtful == v.end() ? 0 : doubtful->vacancy_origin;
}

/// Where a result was rounded: where an operand was, unless the operation rounds whatever it is given.
OriginId rounding_of(ValueTable& table, Operation operation, std::span<const Value> v, const Origin& here) {
    const auto rounded = std::ranges::find(v, Exactness::rounded, &Value::exactness);
    return rounded == v.end() || semantics::always_rounds(operation) ? table.origins(here)
                                                                     : rounded->rounding;
}

Symbol symbol_of(Operation operation, std::span<const Value> v, const Origin& here) {
    const bool fits = v.size() <= 2 && operation != Operation::unknown;
    if (!fits) return Symbol::opaque(here.id, 1, here.node);
    SymbolId first = v[0].symbol;
    SymbolId second = v.size() < 2 ? 0 : v[1].symbol;
    if (semantics::is_commutative(operation) && second < first) std::swap(first, second);
    return Symbol::result_of(operation, first, second);
}

} // namespace

Value compute(ValueTable& table, Operation operation, std::span<const Value> operands, const Origin& here) {
    Value result;
    result.know(semantics::compute(operation, operands.front(), operands[operands.size() < 2 ? 0 : 1]));
    if (semantics::is_whole_number(result)) return number_value(table, result.low);
    if (result.exactness == Exactness::rounded)
        result.rounding = rounding_of(table, operation, operands, here);
    if (semantics::keeps_zero(operation)) result.vacancy_origin = vacancy_origin_of(operands);
    result.symbol = table.symbols(symbol_of(operation, operands, here));
    return result;
}

/// Equal symbols are equal values, whatever they are.
Truth compare(Operation operation, const Value& left, const Value& right, bool vacant_equals_zero) {
    return left.symbol == right.symbol ? semantics::compare_with_itself(operation)
                                       : semantics::compare(operation, left, right, vacant_equals_zero);
}

} // namespace maclint::dataflow
