//! Asks of both sides of such sums whether they are places.
#include "rules/numbers/ratio_as_length_halves_finder.hpp"

#include "analyzer/queries/machine/unfinished_moves.hpp"

#include <algorithm>
#include <optional>
#include <utility>
#include <variant>

namespace maclint::rules {
namespace {

class Finder {
  public:
    explicit Finder(const ProgramAnalysis& analysis)
        : analysis_(analysis)
        , program_(analysis.program()) {}

    [[nodiscard]] std::vector<HalfOfAPlace> run() {
        for (EffectId id = 0; id < program_.effects.size(); ++id) {
            if (const auto* assign = std::get_if<Assign>(&program_.effects[id].what))
                look_at(id, assign->value);
            else if (const auto* words = std::get_if<EvaluateWords>(&program_.effects[id].what))
                for (const ExpressionId value : program_.values_of(*words)) look_at(id, value);
        }
        return std::move(found_);
    }

  private:
    void look_at(EffectId effect, ExpressionId id) {
        const auto* apply = std::get_if<Apply>(&program_.expressions[id].node);
        if (apply == nullptr) return;
        const auto operands = program_.operands_of(*apply);
        if (apply->operation == Operation::add) {
            const auto half = half_in(operands[1]);
            const auto axis = half ? axis_of(effect, *half) : std::nullopt;
            if (axis && axis == axis_of(effect, operands[0])) found_.push_back({effect, id, false});
        }
        if (const auto sum = half_in(id); sum && is_twice_one(*sum)) found_.push_back({effect, id, true});
        for (const ExpressionId operand : operands) look_at(effect, operand);
    }

    /// What the expression is the half of.
    [[nodiscard]] std::optional<ExpressionId> half_in(ExpressionId id) const {
        const auto* quotient = std::get_if<Apply>(&program_.expressions[id].node);
        if (quotient == nullptr || quotient->operation != Operation::divide) return std::nullopt;
        const auto operands = program_.operands_of(*quotient);
        const auto* divisor = std::get_if<Literal>(&program_.expressions[operands[1]].node);
        return divisor != nullptr && divisor->value == 2 ? std::optional(operands[0]) : std::nullopt;
    }

    [[nodiscard]] bool is_twice_one(ExpressionId id) const {
        const auto* sum = std::get_if<Apply>(&program_.expressions[id].node);
        if (sum == nullptr || sum->operation != Operation::add) return false;
        const auto operands = program_.operands_of(*sum);
        const auto* one = std::get_if<Load>(&program_.expressions[operands[0]].node);
        const auto* other = std::get_if<Load>(&program_.expressions[operands[1]].node);
        return one != nullptr && other != nullptr && one->variable == other->variable;
    }

    /// Of the one place that is all that decides the variable, or the number of the machine.
    [[nodiscard]] std::optional<std::int32_t> axis_of(EffectId effect, ExpressionId id) const {
        const auto& node = program_.expressions[id].node;
        if (!std::holds_alternative<Load>(node) && !std::holds_alternative<LoadMachine>(node))
            return std::nullopt;
        const auto places = queries::positions_in(analysis_, effect, id, queries::Positions::when_touched);
        return places.size() == 1 && !places.front().subtracted ? std::optional(places.front().axis)
                                                                : std::nullopt;
    }

    const ProgramAnalysis& analysis_;
    const Program& program_;
    std::vector<HalfOfAPlace> found_;
};

} // namespace

std::vector<HalfOfAPlace> find_halves_of_places(const ProgramAnalysis& analysis) {
    return Finder(analysis).run();
}

} // namespace maclint::rules
