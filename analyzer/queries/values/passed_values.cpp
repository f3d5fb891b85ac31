//! Follows symbols to the values at the program's start, and these to the arguments of a call.
#include "analyzer/queries/values/passed_values.hpp"

#include "analyzer/dataflow/facts/clobber.hpp"
#include "analyzer/dataflow/facts/store.hpp"
#include "analyzer/queries/calls/callers.hpp"
#include "analyzer/semantics/concrete.hpp"
#include "analyzer/workspace/bind.hpp"

#include <algorithm>
#include <array>
#include <span>

namespace maclint::queries {
namespace {

using dataflow::Symbol;
using dataflow::SymbolId;

constexpr int most_operations = 12; ///< that are followed, one in the other

const dataflow::ValueTable& table_of(const ProgramAnalysis& analysis) { return analysis.data().table(); }

/// The operands of a result.
std::vector<SymbolId> operands_of(const Symbol& result) {
    if (result.second() == 0) return {result.first()};
    return {result.first(), result.second()};
}

void collect(const dataflow::ValueTable& table, SymbolId id, int depth, GivenVariables& given) {
    const Symbol& symbol = table.symbols[id];
    if (symbol.kind() == Symbol::Kind::entry) {
        const Variable variable = dataflow::variable_of(symbol.key());
        if (std::ranges::find(given.variables, variable) == given.variables.end())
            given.variables.push_back(variable);
    } else if (symbol.kind() == Symbol::Kind::result && depth > 0) {
        for (const SymbolId operand : operands_of(symbol)) collect(table, operand, depth - 1, given);
    } else if (symbol.kind() != Symbol::Kind::constant && symbol.kind() != Symbol::Kind::vacant) {
        given.closed = false;
    }
}

/// One call, and what it makes of symbols.
class Passed {
  public:
    Passed(const ProgramAnalysis& analysis, const Caller& caller)
        : analysis_(analysis)
        , calling_(calling_program(analysis, caller))
        , caller_(caller) {}

    std::optional<double> number(SymbolId id, int depth) {
        const Symbol& symbol = table_of(analysis_).symbols[id];
        if (const auto constant = table_of(analysis_).number_of(id)) return constant;
        if (symbol.kind() == Symbol::Kind::vacant) return 0;
        if (symbol.kind() == Symbol::Kind::entry) return argument(dataflow::variable_of(symbol.key()));
        if (symbol.kind() != Symbol::Kind::result || depth == 0) return std::nullopt;
        std::vector<double> operands;
        for (const SymbolId operand : operands_of(symbol)) {
            const auto value = number(operand, depth - 1);
            if (!value) return std::nullopt;
            operands.push_back(*value);
        }
        return calculate(symbol.operation(), operands);
    }

    [[nodiscard]] std::optional<Variable> left_out() const { return left_out_; }

  private:
    static std::optional<double> calculate(Operation operation, std::span<const double> operands) {
        const semantics::Result result = semantics::compute(operation, operands);
        const auto* number = std::get_if<double>(&result);
        return number == nullptr ? std::nullopt : std::optional(*number);
    }

    std::optional<double> argument(Variable variable) {
        const Program& program = calling_.program();
        const Call& call = call_of(program, caller_.effect);
        if (!analysis_.program().is_formal(variable)) return std::nullopt;
        for (const Argument& argument : program.arguments_of(call))
            if (bound_to(argument, &analysis_.program()) == variable) return written(argument.value);
        if (const auto* declared = analysis_.program().declaration_of(variable);
            declared != nullptr && declared->initial)
            return declared->initial;
        left_out_ = variable;
        return 0;
    }

    /// The number that stands in the call.
    [[nodiscard]] std::optional<double> written(ExpressionId id) const {
        const Program& program = calling_.program();
        const auto& node = program.expressions[id].node;
        if (const auto* literal = std::get_if<Literal>(&node)) return literal->value;
        const auto* apply = std::get_if<Apply>(&node);
        if (apply == nullptr) return std::nullopt;
        std::vector<double> operands;
        for (const ExpressionId operand : program.operands_of(*apply)) {
            const auto value = written(operand);
            if (!value) return std::nullopt;
            operands.push_back(*value);
        }
        return calculate(apply->operation, operands);
    }

    const ProgramAnalysis& analysis_;
    const ProgramAnalysis& calling_;
    const Caller& caller_;
    std::optional<Variable> left_out_;
};

} // namespace

GivenVariables given_variables(const ProgramAnalysis& analysis, const dataflow::Value& value) {
    GivenVariables given;
    collect(table_of(analysis), value.symbol, most_operations, given);
    return given;
}

const std::vector<Variable>& ZeroSources::of(SymbolId value) {
    const auto [known, fresh] = known_.try_emplace(value);
    if (fresh) collect(value, most_operations, known->second);
    return known->second;
}

/// Whether a number other than 0 is all that the program ever gives the variable: `IF[#6EQ#0]THEN#6=1.`
bool ZeroSources::has_only_defaults(Variable variable) {
    const auto [known, fresh] = has_only_defaults_.try_emplace(variable);
    if (!fresh) return known->second;
    const auto& facts = analysis_.facts();
    const auto is_default = [](const dataflow::Store* store) {
        return store->value.constant() && !store->value.can_be(0);
    };
    const auto changes = [&](const dataflow::Clobber& clobber) { return clobber.may_change(variable); };
    return known->second = std::ranges::all_of(facts.about<dataflow::Store>(variable), is_default) &&
                           std::ranges::none_of(facts.all<dataflow::Clobber>(), changes);
}

void ZeroSources::collect(SymbolId id, int depth, std::vector<Variable>& zeros) {
    const Symbol& symbol = table_of(analysis_).symbols[id];
    if (symbol.kind() == Symbol::Kind::entry) zeros.push_back(dataflow::variable_of(symbol.key()));
    if (symbol.kind() == Symbol::Kind::joined && dataflow::is_variable_key(symbol.key())) {
        // What is joined may still be the value at the start.
        const Variable variable = dataflow::variable_of(symbol.key());
        if (has_only_defaults(variable) && without_assignment_.leads_to(variable, symbol.met_at()))
            zeros.push_back(variable);
    }
    if (symbol.kind() != Symbol::Kind::result || depth == 0) return;
    switch (symbol.operation()) {
    case Operation::multiply: collect(symbol.second(), depth - 1, zeros); [[fallthrough]];
    case Operation::divide:
    case Operation::negate:
    case Operation::absolute:
    case Operation::sine:
    case Operation::tangent:
    case Operation::square_root:
    case Operation::round:
    case Operation::truncate:
    case Operation::round_up: collect(symbol.first(), depth - 1, zeros); break;
    default: break;
    }
}

std::optional<PassedValue> value_for(const ProgramAnalysis& analysis, const Caller& caller,
                                     const dataflow::Value& value) {
    Passed passed(analysis, caller);
    const auto number = passed.number(value.symbol, most_operations);
    return number ? std::optional(PassedValue{*number, passed.left_out()}) : std::nullopt;
}

} // namespace maclint::queries
