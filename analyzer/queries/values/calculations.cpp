//! Reads the symbols of results.
#include "analyzer/queries/values/calculations.hpp"

#include "analyzer/dataflow/domain/read_set.hpp"
#include "analyzer/program/tables.hpp"

#include <algorithm>
#include <cmath>

namespace maclint::queries {
namespace {

const dataflow::Symbol& symbol_of(const ProgramAnalysis& analysis, const dataflow::Value& value) {
    return analysis.data().table().symbols[value.symbol];
}

/// The results that a value is made of.
class Calculation {
  public:
    explicit Calculation(const dataflow::ValueTable& table)
        : table_(table) {}

    [[nodiscard]] bool is_whole(dataflow::SymbolId id) const {
        if (const auto number = table_.number_of(id)) return std::floor(*number) == *number;
        const auto operation = operation_of(id);
        return operation == Operation::truncate || operation == Operation::round ||
               operation == Operation::round_up;
    }

    /// What is no result is what it is. `depth` operations deep nothing is known.
    [[nodiscard]] bool is_zero_as_on_paper(dataflow::SymbolId id, int depth = 16) const {
        const auto operation = operation_of(id);
        if (!operation) return true;
        if (depth == 0) return false;
        const dataflow::Symbol& s = table_.symbols[id];
        const auto safe = [&](dataflow::SymbolId operand) { return is_zero_as_on_paper(operand, depth - 1); };
        switch (*operation) {
        case Operation::multiply: return safe(s.first()) && safe(s.second());
        case Operation::divide:
        case Operation::negate:
        case Operation::absolute:
        case Operation::square_root: return safe(s.first());
        case Operation::add:
            return is_unrounded(id) ||
                   (safe(s.first()) && safe(s.second()) && is_never_negative(s.first(), depth) &&
                    is_never_negative(s.second(), depth));
        case Operation::truncate:
        case Operation::round:
        case Operation::round_up: return true;
        default: return is_unrounded(id);
        }
    }

    [[nodiscard]] std::optional<Operation> operation_of(dataflow::SymbolId id) const {
        const dataflow::Symbol& s = table_.symbols[id];
        if (s.kind() != dataflow::Symbol::Kind::result) return std::nullopt;
        return s.operation();
    }

  private:
    [[nodiscard]] bool is_never_negative(dataflow::SymbolId id, int depth) const {
        if (const auto number = table_.number_of(id)) return *number >= 0;
        const auto operation = operation_of(id);
        if (!operation || depth == 0) return false;
        const dataflow::Symbol& s = table_.symbols[id];
        if (operation == Operation::multiply) return s.first() == s.second();
        if (operation == Operation::add)
            return is_never_negative(s.first(), depth - 1) && is_never_negative(s.second(), depth - 1);
        return operation == Operation::absolute || operation == Operation::square_root;
    }

    /// Sums and differences of what is read, measured or whole: nothing in it has been rounded for certain.
    [[nodiscard]] bool is_unrounded(dataflow::SymbolId id, int depth = 16) const {
        if (table_.number_of(id)) return is_whole(id);
        const auto operation = operation_of(id);
        if (!operation || is_whole(id)) return true;
        if (depth == 0) return false;
        const dataflow::Symbol& s = table_.symbols[id];
        if (operation == Operation::negate || operation == Operation::absolute)
            return is_unrounded(s.first(), depth - 1);
        return (operation == Operation::subtract || operation == Operation::add) &&
               is_unrounded(s.first(), depth - 1) && is_unrounded(s.second(), depth - 1);
    }

    const dataflow::ValueTable& table_;
};

} // namespace

std::optional<Operation> operation_of(const ProgramAnalysis& analysis, const dataflow::Value& value) {
    const dataflow::Symbol& symbol = symbol_of(analysis, value);
    if (symbol.kind() != dataflow::Symbol::Kind::result) return std::nullopt;
    return symbol.operation();
}

bool is_rounded_result(const ProgramAnalysis& analysis, const dataflow::Value& value,
                       const dataflow::Value& of) {
    const auto operation = operation_of(analysis, value);
    const bool rounds =
        operation == Operation::truncate || operation == Operation::round || operation == Operation::round_up;
    return rounds && symbol_of(analysis, value).first() == of.symbol;
}

bool is_quotient_of_decimals(const ProgramAnalysis& analysis, const dataflow::Value& value) {
    return operation_of(analysis, value) == Operation::divide &&
           !Calculation(analysis.data().table()).is_whole(symbol_of(analysis, value).second());
}

bool are_rounded_alike(const ProgramAnalysis& analysis, const dataflow::Value& one,
                       const dataflow::Value& other) {
    const Calculation calculation(analysis.data().table());
    const auto is_whole_in_units = [&](const dataflow::Value& value) {
        return operation_of(analysis, value) == Operation::divide &&
               calculation.is_whole(symbol_of(analysis, value).first());
    };
    return is_whole_in_units(one) && is_whole_in_units(other) &&
           symbol_of(analysis, one).second() == symbol_of(analysis, other).second();
}

bool is_zero_as_on_paper(const ProgramAnalysis& analysis, const dataflow::Value& value) {
    return Calculation(analysis.data().table()).is_zero_as_on_paper(value.symbol);
}

bool is_as_written(double number) {
    constexpr double decimals = 1e9;
    constexpr double largest = 1e6; // above that a double has no room for so many decimals
    return std::abs(number) < largest && std::round(number * decimals) / decimals == number;
}

bool is_as_written(const dataflow::Value& value) {
    const auto number = value.constant();
    return number && is_as_written(*number);
}

bool is_of_own_variables(const ProgramAnalysis& analysis, ExpressionId expression) {
    const auto reads = dataflow::variables_of(analysis.program(), expression);
    return reads.closed && std::ranges::all_of(reads.variables, [&](Variable variable) {
               return analysis.control().spaces[variable.space].scope == Scope::frame;
           });
}

bool is_distance(const ProgramAnalysis& analysis, const dataflow::Value& value) {
    return operation_of(analysis, value) == Operation::absolute &&
           Calculation(analysis.data().table()).operation_of(symbol_of(analysis, value).first()) ==
               Operation::subtract;
}

} // namespace maclint::queries
