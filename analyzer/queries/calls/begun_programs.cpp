//! Holds numbers of calls against what the control makes of them, and walks with them.
#include "analyzer/queries/calls/begun_programs.hpp"

#include "analyzer/dataflow/facts/read.hpp"
#include "analyzer/flow/walk.hpp"
#include "analyzer/program/tables.hpp"
#include "analyzer/queries/calls/callers.hpp"
#include "analyzer/queries/calls/shown_calls.hpp"
#include "analyzer/queries/values/calculations.hpp"
#include "analyzer/semantics/concrete.hpp"

#include <algorithm>
#include <string_view>
#include <utility>
#include <variant>

namespace maclint::queries {
namespace {

using dataflow::CallBegun;
using dataflow::KnownStart;
using dataflow::KnownVariable;
using dataflow::Read;

constexpr std::size_t most_calls = 16;      ///< with numbers that are followed into one program
constexpr std::size_t most_looked_at = 256; ///< calls of one program
constexpr std::size_t most_nodes = 1000;    ///< of a program that is run again for a call

bool is_certain(const ProgramAnalysis& calling, EffectId effect, const KnownVariable& known) {
    if (!is_as_written(*known.number)) return false;
    const Program& program = calling.program();
    const auto arguments = program.arguments_of(call_of(program, effect));
    const auto passed = std::ranges::find_if(arguments, [&](const Argument& argument) {
        const auto* given = std::get_if<Variable>(&argument.given);
        return given != nullptr && *given == known.variable;
    });
    const auto* literal =
        passed == arguments.end() ? nullptr : std::get_if<Literal>(&program.expressions[passed->value].node);
    return literal == nullptr ||
           is_number_as_written(calling.control(), passed->address, literal->value, literal->decimal_point);
}

/// What expressions are in a program that is begun so. Functions whose last digit no manual tells are taken
/// for exact: who asks allows for that.
class Numbers {
  public:
    Numbers(const Program& program, const dataflow::Analysis& begun)
        : program_(program)
        , begun_(begun) {}

    /// Of an expression that the effect evaluates; at most `left` assignments are followed back.
    [[nodiscard]] std::optional<double> of(EffectId effect, ExpressionId id,
                                           int left = most_assignments) const {
        const auto& node = program_.expressions[id].node;
        if (const auto* literal = std::get_if<Literal>(&node)) return literal->value;
        if (std::holds_alternative<Load>(node)) return of_variable(effect, id, left);
        const auto* apply = std::get_if<Apply>(&node);
        if (apply == nullptr) return std::nullopt;
        std::vector<double> operands;
        for (const ExpressionId operand : program_.operands_of(*apply)) {
            const auto number = of(effect, operand, left);
            if (!number) return std::nullopt;
            operands.push_back(*number);
        }
        const semantics::Result result = semantics::compute(apply->operation, operands);
        const auto* number = std::get_if<double>(&result);
        return number == nullptr ? std::nullopt : std::optional(*number);
    }

  private:
    static constexpr int most_assignments = 8; ///< one made of another

    [[nodiscard]] std::optional<double> of_variable(EffectId effect, ExpressionId id, int left) const {
        const auto reads = begun_.facts().at<Read>(effect);
        const auto read = std::ranges::find(reads, id, &Read::expression);
        if (read == reads.end()) return std::nullopt;
        if (const auto number = read->value.constant()) return number;
        const dataflow::Origin origin = begun_.table().origins[read->value.origin];
        if (left == 0 || origin.kind != dataflow::Origin::Kind::effect) return std::nullopt;
        const auto* made = std::get_if<Assign>(&program_.effects[origin.id].what);
        return made == nullptr ? std::nullopt : of(origin.id, made->value, left - 1);
    }

    const Program& program_;
    const dataflow::Analysis& begun_;
};

/// Whether a path that comes by none of the nodes leaves the program other than by an alarm.
bool may_leave_around(const flow::Graph& graph, const dataflow::Analysis& begun,
                      const std::vector<bool>& nodes) {
    const auto leaves = [&](flow::NodeId node) {
        return std::ranges::any_of(graph.exits_at(node),
                                   [](const flow::Exit& exit) { return exit.kind != flow::ExitKind::alarm; });
    };
    if (nodes[0]) return false;
    bool is_left = leaves(0);
    flow::walk<flow::Direction::forward>(graph, {0}, [&](flow::EdgeId edge, flow::NodeId to) {
        if (is_left || nodes[to] || !begun.passable(edge)) return flow::Step::refuse;
        is_left = leaves(to);
        return flow::Step::go_on;
    });
    return is_left;
}

} // namespace

bool has_number(const KnownVariable& known) { return known.number.has_value(); }
bool has_numbers(const KnownStart& start) { return std::ranges::any_of(start.known, has_number); }

std::optional<KnownStart> certain_numbers(const ProgramAnalysis& calling, const CallBegun& begun) {
    if (!has_numbers(begun.with_numbers)) return std::nullopt;
    KnownStart start = begun.with_numbers;
    std::erase_if(start.known, [&](const KnownVariable& known) {
        return has_number(known) && !is_certain(calling, begun.effect, known);
    });
    return has_numbers(start) ? std::optional(std::move(start)) : std::nullopt;
}

bool is_number_as_written(const ControlModel& control, std::string_view address, double value,
                          bool decimal_point) {
    return decimal_point || value == 0 || control.calculator_input ||
           control.numbering_arguments.find(address) != std::string_view::npos;
}

std::vector<NumberedCall> calls_with_numbers(const ProgramAnalysis& analysis) {
    std::vector<NumberedCall> calls;
    if (analysis.graph().nodes.size() > most_nodes) return calls;
    for (ShownCall& shown : shown_calls(analysis))
        calls.push_back({&analysis, shown.span, true, std::move(shown.start), std::nullopt});
    std::size_t looked_at = 0;
    for (const Caller& caller : analysis.callers()) {
        const ProgramAnalysis& calling = calling_program(analysis, caller);
        for (const CallBegun& begun : calling.facts().at<CallBegun>(caller.effect)) {
            if (looked_at++ == most_looked_at) return calls;
            auto start = certain_numbers(calling, begun);
            if (!start || std::ranges::find(calls, *start, &NumberedCall::start) != calls.end()) continue;
            calls.push_back({&calling, calling.program().effects[begun.effect].span, false, *std::move(start),
                             begun.effect});
            if (calls.size() == most_calls) return calls;
        }
    }
    return calls;
}

bool always_comes_by(const flow::Graph& graph, const dataflow::Analysis& begun,
                     const std::vector<bool>& nodes) {
    const std::vector<bool> none(graph.nodes.size(), false);
    return may_leave_around(graph, begun, none) && !may_leave_around(graph, begun, nodes) && Budget::allows();
}

std::unordered_map<ExpressionId, double> numbers_of_words(const Program& program,
                                                          const dataflow::Analysis& begun) {
    std::unordered_map<ExpressionId, double> numbers;
    const Numbers known(program, begun);
    for (EffectId effect = 0; effect < program.effects.size(); ++effect)
        if (const auto* values = std::get_if<EvaluateWords>(&program.effects[effect].what))
            for (const ExpressionId value : program.values_of(*values))
                if (const auto number = known.of(effect, value)) numbers.emplace(value, *number);
    return numbers;
}

} // namespace maclint::queries
