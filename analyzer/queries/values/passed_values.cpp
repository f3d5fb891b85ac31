//! Follows symbols to the values at the program's start, and these to the arguments of a call.
#include "analyzer/queries/values/passed_values.hpp"

#include "analyzer/dataflow/facts/clobber.hpp"
#include "analyzer/dataflow/facts/read.hpp"
#include "analyzer/dataflow/facts/store.hpp"
#include "analyzer/queries/calls/callers.hpp"
#include "analyzer/queries/paths/exits.hpp"
#include "analyzer/semantics/concrete.hpp"
#include "analyzer/source/budget.hpp"
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

/// Calls in a row: the first begins the program, each other one that in which the one before stands.
using Calls = std::vector<const Caller*>;
constexpr int most_calls = 4;
constexpr std::size_t most_rows = 64; ///< of calls to one

/// What calls in a row make of symbols.
class Passed {
  public:
    Passed(const ProgramAnalysis& analysis, std::span<const Caller* const> calls)
        : analysis_(analysis)
        , calling_(calling_program(analysis, *calls.front()))
        , calls_(calls) {}

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
    /// Whether a further call would tell more.
    [[nodiscard]] bool is_handed_on() const { return is_handed_on_; }

  private:
    static std::optional<double> calculate(Operation operation, std::span<const double> operands) {
        const semantics::Result result = semantics::compute(operation, operands);
        const auto* number = std::get_if<double>(&result);
        return number == nullptr ? std::nullopt : std::optional(*number);
    }

    std::optional<double> argument(Variable variable) {
        const Program& program = calling_.program();
        const Call& call = call_of(program, calls_.front()->effect);
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
    [[nodiscard]] std::optional<double> written(ExpressionId id) {
        const Program& program = calling_.program();
        const auto& node = program.expressions[id].node;
        if (const auto* literal = std::get_if<Literal>(&node)) return literal->value;
        if (std::holds_alternative<Load>(node)) return handed_on(id);
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

    /// What the calling program passes of what it was given: nothing where its caller leaves that out.
    std::optional<double> handed_on(ExpressionId id) {
        const auto reads = calling_.facts().at<dataflow::Read>(calls_.front()->effect);
        const auto read = std::ranges::find(reads, id, &dataflow::Read::expression);
        if (read == reads.end()) return std::nullopt;
        if (calls_.size() == 1) {
            is_handed_on_ |= !given_variables(calling_, read->value).variables.empty();
            return read->value.constant();
        }
        Passed further(calling_, calls_.subspan(1));
        const auto number = further.number(read->value.symbol, most_operations);
        is_handed_on_ |= further.is_handed_on_;
        return further.left_out_ ? std::nullopt : number;
    }

    const ProgramAnalysis& analysis_;
    const ProgramAnalysis& calling_;
    std::span<const Caller* const> calls_;
    std::optional<Variable> left_out_;
    bool is_handed_on_ = false;
};

/// Whether the program that the call stands in always comes to it.
bool is_always_made(const ProgramAnalysis& calling, const Caller& call) {
    const auto node = calling.graph().node_of(call.effect);
    return node && calling.data().reached(*node) && is_on_every_path(calling, *node);
}

std::optional<PassedValue> value_for(const ProgramAnalysis& analysis, const Caller& caller,
                                     const dataflow::Value& value,
                                     const std::function<bool(const PassedValue&)>& wanted) {
    std::vector<Calls> rows{{&caller}};
    for (std::size_t next = 0; next < rows.size() && Budget::allows(); ++next) {
        const Calls calls = rows[next];
        Passed passed(analysis, calls);
        const auto number = passed.number(value.symbol, most_operations);
        const PassedValue found{number.value_or(0), passed.left_out(), calls.back()};
        if (number && wanted(found)) return found;
        const ProgramAnalysis& last = analysis.workspace().programs()[calls.back()->program];
        if (number || !passed.is_handed_on() || calls.size() == std::size_t{most_calls} ||
            !is_always_made(last, *calls.back()))
            continue;
        for (const Caller& further : last.callers()) {
            if (rows.size() == most_rows) break;
            if (further.program == calls.back()->program || !opens_locals(last, further)) continue;
            rows.push_back(calls);
            rows.back().push_back(&further);
        }
    }
    return std::nullopt;
}

bool is_never_zero(const ProgramAnalysis& analysis, Variable variable, int further_calls);

/// Whether the number that the call passes there is known to be another than 0. What the program hands on as
/// it was given it is one of its own callers.
bool is_never_zero(const ProgramAnalysis& calling, EffectId call, ExpressionId passed, int further_calls) {
    if (const auto* literal = std::get_if<Literal>(&calling.program().expressions[passed].node))
        return literal->value != 0;
    return std::ranges::any_of(calling.facts().at<dataflow::Read>(call), [&](const dataflow::Read& read) {
        if (read.expression != passed) return false;
        const Symbol& symbol = calling.data().table().symbols[read.value.symbol];
        return !read.value.can_be(0) ||
               (further_calls > 0 && symbol.is_entry_of(dataflow::key_of(read.variable)) &&
                is_never_zero(calling, read.variable, further_calls - 1));
    });
}

bool is_never_zero(const ProgramAnalysis& analysis, Variable variable, int further_calls) {
    return !analysis.callers().empty() && std::ranges::all_of(analysis.callers(), [&](const Caller& caller) {
        const ProgramAnalysis& calling = calling_program(analysis, caller);
        const auto arguments = calling.program().arguments_of(call_of(calling.program(), caller.effect));
        return std::ranges::any_of(arguments, [&](const Argument& argument) {
            return bound_to(argument, &analysis.program()) == variable &&
                   is_never_zero(calling, caller.effect, argument.value, further_calls);
        });
    });
}

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

std::optional<PassedValue> value_for_a_call(const ProgramAnalysis& analysis, const dataflow::Value& value,
                                            const std::function<bool(const PassedValue&)>& wanted) {
    for (const Caller& caller : analysis.callers()) {
        if (!Budget::allows()) return std::nullopt;
        const ProgramAnalysis& calling = calling_program(analysis, caller);
        const auto node = calling.graph().node_of(caller.effect);
        if (caller.program == analysis.index() || !node || !calling.data().reached(*node) ||
            !opens_locals(analysis, caller))
            continue;
        if (const auto passed = value_for(analysis, caller, value, wanted)) return passed;
    }
    return std::nullopt;
}

bool is_never_passed_as_zero(const ProgramAnalysis& analysis, Variable variable) {
    return is_never_zero(analysis, variable, most_calls - 1);
}

bool is_never_passed_as_zero(const ProgramAnalysis& analysis, const dataflow::Value& value) {
    const Symbol& symbol = table_of(analysis).symbols[value.symbol];
    return symbol.kind() == Symbol::Kind::entry && dataflow::is_variable_key(symbol.key()) &&
           is_never_passed_as_zero(analysis, dataflow::variable_of(symbol.key()));
}

} // namespace maclint::queries
