//! Reads the symbols of results.
#include "analyzer/queries/calculations.hpp"

namespace maclint::queries {
namespace {

const dataflow::Symbol& symbol_of(const ProgramAnalysis& analysis, const dataflow::Value& value) {
    return analysis.data().table().symbols[value.symbol];
}

} // namespace

std::optional<Operation> operation_of(const ProgramAnalysis& analysis, const dataflow::Value& value) {
    const dataflow::Symbol& symbol = symbol_of(analysis, value);
    if (symbol.kind != dataflow::Symbol::Kind::result) return std::nullopt;
    return static_cast<Operation>(symbol.a);
}

bool is_rounded_result(const ProgramAnalysis& analysis, const dataflow::Value& value,
                       const dataflow::Value& of) {
    const auto operation = operation_of(analysis, value);
    const bool rounds =
        operation == Operation::truncate || operation == Operation::round || operation == Operation::round_up;
    return rounds && symbol_of(analysis, value).b == of.symbol;
}

} // namespace maclint::queries
