//! Holds the axis of each offset that is set against those of the positions in it.
#include "rules/variables/crossed_axes_positions_finder.hpp"

#include "analyzer/dataflow/facts/store.hpp"
#include "analyzer/program/tables.hpp"
#include "analyzer/queries/machine/unfinished_moves.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <variant>

namespace maclint::rules {
namespace {

/// A number that goes by axes.
struct AxisNumber {
    const VariableRange* range;
    std::int32_t number;

    [[nodiscard]] std::int32_t axis() const { return range->axis(number); }
    [[nodiscard]] Variable of(std::int32_t other) const { return {range->space, number - axis() + other}; }
};

class Finder {
  public:
    explicit Finder(const ProgramAnalysis& analysis)
        : analysis_(analysis)
        , program_(analysis.program()) {}

    [[nodiscard]] std::vector<PositionOfAnotherAxis> run() const {
        std::vector<PositionOfAnotherAxis> found;
        for (EffectId id = 0; id < program_.effects.size(); ++id) {
            const auto* assign = std::get_if<Assign>(&program_.effects[id].what);
            const auto offset = assign == nullptr ? std::nullopt : offset_set_by(*assign);
            if (!offset || !Budget::allows()) continue;
            if (const auto other = other_axis_in(id, *assign, *offset)) found.push_back(*other);
        }
        return found;
    }

  private:
    [[nodiscard]] std::optional<AxisNumber> number(FamilyId family, std::int64_t number) const {
        const VariableRange* range = analysis_.control().families[family].find(number);
        if (range == nullptr || range->numbers_of_a_set == 0) return std::nullopt;
        return AxisNumber{range, static_cast<std::int32_t>(number)};
    }

    [[nodiscard]] std::optional<AxisNumber> offset(FamilyId family, std::int64_t of) const {
        const auto found = number(family, of);
        return found && found->range->first_code && found->axis() <= most_linear_axes ? found : std::nullopt;
    }

    /// The only assignment of a variable that nothing else sets.
    [[nodiscard]] std::optional<ExpressionId> only_value_of(Variable variable) const {
        const auto stores = analysis_.facts().about<dataflow::Store>(variable);
        return stores.size() == 1 ? std::optional(stores.front()->expression) : std::nullopt;
    }

    /// 5221+20*[#19-54] is the axis of 5221, whichever set it is.
    [[nodiscard]] std::optional<AxisNumber> base_in(FamilyId family, ExpressionId index, int depth) const {
        const auto& node = program_.expressions[index].node;
        if (const auto* literal = std::get_if<Literal>(&node))
            return offset(family, std::llround(literal->value));
        if (const auto* load = std::get_if<Load>(&node)) {
            const auto value = depth == 0 ? std::nullopt : only_value_of(load->variable);
            return value ? base_in(family, *value, depth - 1) : std::nullopt;
        }
        const auto* sum = std::get_if<Apply>(&node);
        if (sum == nullptr || sum->operation != Operation::add) return std::nullopt;
        const auto operands = program_.operands_of(*sum);
        for (const std::size_t i : {0U, 1U}) {
            const auto base = base_in(family, operands[i], 0);
            if (base && counts_sets(*base->range, operands[1 - i])) return base;
            if (const auto next = next_of(operands[i], operands[1 - i], family, depth)) return next;
        }
        return std::nullopt;
    }

    /// #11+2 is the axis two further than that of #11.
    [[nodiscard]] std::optional<AxisNumber> next_of(ExpressionId start, ExpressionId further, FamilyId family,
                                                    int depth) const {
        const auto* literal = std::get_if<Literal>(&program_.expressions[further].node);
        const bool is_variable = std::holds_alternative<Load>(program_.expressions[start].node);
        if (literal == nullptr || !is_variable || literal->value < 0 || literal->value >= most_linear_axes)
            return std::nullopt;
        const auto base = base_in(family, start, depth);
        return base ? offset(family, base->number + std::llround(literal->value)) : std::nullopt;
    }

    [[nodiscard]] bool counts_sets(const VariableRange& range, ExpressionId id) const {
        const auto* product = std::get_if<Apply>(&program_.expressions[id].node);
        if (product == nullptr || product->operation != Operation::multiply) return false;
        return std::ranges::any_of(program_.operands_of(*product), [&](ExpressionId factor) {
            const auto* literal = std::get_if<Literal>(&program_.expressions[factor].node);
            return literal != nullptr && literal->value == range.numbers_of_a_set;
        });
    }

    [[nodiscard]] std::optional<AxisNumber> offset_set_by(const Assign& assign) const {
        if (const auto* plain = std::get_if<StoreMachine>(&assign.target))
            return offset(plain->family, plain->number);
        const auto* indexed = std::get_if<StoreAt>(&assign.target);
        return indexed == nullptr ? std::nullopt : base_in(indexed->family, indexed->index, 1);
    }

    /// Whether the value takes a number of another axis's offset.
    [[nodiscard]] bool takes_other_offset(ExpressionId id, const AxisNumber& own) const {
        const auto& node = program_.expressions[id].node;
        if (const auto* load = std::get_if<LoadMachine>(&node)) {
            const auto taken = number(load->family, load->number);
            return taken && taken->range->on_write == OnWrite::store && taken->axis() != own.axis();
        }
        const auto* apply = std::get_if<Apply>(&node);
        return apply != nullptr &&
               std::ranges::any_of(program_.operands_of(*apply),
                                   [&](ExpressionId operand) { return takes_other_offset(operand, own); });
    }

    [[nodiscard]] bool reads(FamilyId family, std::int32_t wanted) const {
        return std::ranges::any_of(program_.expressions, [&](const Expression& expression) {
            const auto* load = std::get_if<LoadMachine>(&expression.node);
            return load != nullptr && load->family == family && load->number == wanted;
        });
    }

    [[nodiscard]] std::optional<PositionOfAnotherAxis> other_axis_in(EffectId id, const Assign& assign,
                                                                     const AxisNumber& own) const {
        const auto positions =
            queries::positions_in(analysis_, id, assign.value, queries::Positions::when_touched);
        const auto is_other = [&](const queries::PositionRead& position) {
            return position.axis + 1 != own.axis() && position.axis == positions.front().axis &&
                   position.axis < most_linear_axes;
        };
        if (positions.empty() || !std::ranges::all_of(positions, is_other) ||
            takes_other_offset(assign.value, own))
            return std::nullopt;
        const ExpressionId at = positions.front().expression;
        const auto* load = std::get_if<LoadMachine>(&program_.expressions[at].node);
        const auto position = load == nullptr ? std::nullopt : number(load->family, load->number);
        if (!position) return std::nullopt;
        const Variable meant = position->of(own.axis());
        if (!reads(load->family, meant.number)) return std::nullopt;
        return PositionOfAnotherAxis{id, at, meant, {own.range->space, own.number}};
    }

    static constexpr std::int32_t most_linear_axes = 3; ///< those behind turn
    const ProgramAnalysis& analysis_;
    const Program& program_;
};

} // namespace

std::vector<PositionOfAnotherAxis> find_positions_of_other_axes(const ProgramAnalysis& analysis) {
    return Finder(analysis).run();
}

} // namespace maclint::rules
