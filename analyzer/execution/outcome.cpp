//! AND, OR, NOT and their opposites in one form: OR is NOT of AND, the order of what they join does not
//! count.
#include "analyzer/execution/outcome.hpp"

#include "analyzer/dataflow/domain/arithmetic.hpp"

#include <algorithm>
#include <utility>
#include <vector>

namespace maclint::execution {
namespace {

using dataflow::Symbol;
using dataflow::SymbolId;

constexpr int most_comparisons = 16;

class Naming {
  public:
    Naming(const Program& program, dataflow::Transfer& transfer, dataflow::ValueTable& table,
           const dataflow::State& state)
        : program_(program)
        , transfer_(transfer)
        , table_(table)
        , state_(state) {}

    std::optional<Outcome> name(ExpressionId condition) {
        const auto* apply = std::get_if<Apply>(&program_.expressions[condition].node);
        if (apply == nullptr || ++comparisons_ > most_comparisons) return std::nullopt;
        const auto operands = program_.operands_of(*apply);
        switch (apply->operation) {
        case Operation::all_of: return all_of(operands, false);
        case Operation::any_of: return all_of(operands, true);
        case Operation::not_of: return opposite_if(true, name(operands.front()));
        case Operation::is_vacant:
        case Operation::is_set:
            return vacancy(value(operands.front()), apply->operation == Operation::is_set);
        default: break;
        }
        if (!dataflow::is_comparison(apply->operation) || operands.size() != 2) return std::nullopt;
        return comparison(apply->operation, value(operands.front()), value(operands.back()));
    }

  private:
    static std::optional<Outcome> opposite_if(bool negated, std::optional<Outcome> outcome) {
        if (outcome) outcome->negated ^= negated;
        return outcome;
    }

    /// Whether all are true; `opposites`: whether all are false, negated.
    std::optional<Outcome> all_of(std::span<const ExpressionId> operands, bool opposites) {
        std::vector<SymbolId> parts;
        if (!add_parts(operands, opposites, parts)) return std::nullopt;
        std::ranges::sort(parts);
        SymbolId all = parts.front();
        for (std::size_t i = 1; i < parts.size(); ++i) all = result(Operation::all_of, all, parts[i]);
        return Outcome{all, opposites};
    }

    /// A AND B AND C is A AND B, AND C: its parts are three.
    bool add_parts(std::span<const ExpressionId> operands, bool opposites, std::vector<SymbolId>& parts) {
        const Operation same = opposites ? Operation::any_of : Operation::all_of;
        return std::ranges::all_of(operands, [&](ExpressionId operand) {
            const auto* apply = std::get_if<Apply>(&program_.expressions[operand].node);
            if (apply != nullptr && apply->operation == same && ++comparisons_ <= most_comparisons)
                return add_parts(program_.operands_of(*apply), opposites, parts);
            const auto part = opposite_if(opposites, name(operand));
            if (part)
                parts.push_back(part->negated ? result(Operation::not_of, part->symbol, 0) : part->symbol);
            return part.has_value();
        });
    }

    std::optional<Outcome> vacancy(SymbolId value, bool negated) {
        if (value == 0) return std::nullopt; // nothing is said of it
        return Outcome{result(Operation::is_vacant, value, 0), negated};
    }

    std::optional<Outcome> comparison(Operation operation, SymbolId left, SymbolId right) {
        if (left == 0 || right == 0) return std::nullopt;
        const bool negated = operation == Operation::not_equal || operation == Operation::less_equal ||
                             operation == Operation::greater_equal;
        if (negated) operation = dataflow::opposite(operation);
        const bool mirror =
            operation == Operation::greater || (operation == Operation::equal && right < left);
        if (mirror) {
            operation = dataflow::mirrored(operation);
            std::swap(left, right);
        }
        return Outcome{result(operation, left, right), negated};
    }

    SymbolId value(ExpressionId expression) { return transfer_.value_in(state_, expression).symbol; }
    SymbolId result(Operation operation, SymbolId first, SymbolId second) {
        return table_.symbols(Symbol::result_of(operation, first, second));
    }

    const Program& program_;
    dataflow::Transfer& transfer_;
    dataflow::ValueTable& table_;
    const dataflow::State& state_;
    int comparisons_ = 0;
};

bool joins(Operation operation) {
    return operation == Operation::all_of || operation == Operation::any_of || operation == Operation::not_of;
}

} // namespace

std::optional<Outcome> outcome_of(const Program& program, dataflow::Transfer& transfer,
                                  dataflow::ValueTable& table, const dataflow::State& state,
                                  ExpressionId condition) {
    const auto* apply = std::get_if<Apply>(&program.expressions[condition].node);
    if (apply == nullptr || !joins(apply->operation)) return std::nullopt;
    return Naming(program, transfer, table, state).name(condition);
}

} // namespace maclint::execution
