//! Looks for factors of pi and 180 on the way into and out of the functions of angles.
#include "rules/numbers/angle_in_radians_finder.hpp"

#include "analyzer/dataflow/facts/read.hpp"
#include "analyzer/dataflow/facts/store.hpp"
#include "analyzer/queries/calls/callers.hpp"
#include "analyzer/queries/values/calculations.hpp"
#include "analyzer/queries/values/copies.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <unordered_map>
#include <variant>
#include <vector>

namespace maclint::rules {
namespace {

bool is_arc(Operation operation) {
    return operation == Operation::arc_sine || operation == Operation::arc_cosine ||
           operation == Operation::arc_tangent || operation == Operation::arc_tangent_of_two;
}

bool is_trigonometric(Operation operation) {
    return operation == Operation::sine || operation == Operation::cosine || operation == Operation::tangent;
}

bool is_scaling(const Apply* apply) {
    return apply != nullptr &&
           (apply->operation == Operation::multiply || apply->operation == Operation::divide);
}

/// The function SIN, COS or TAN to which the program gives the argument as it was passed.
std::optional<ExpressionId> function_of_argument(const ProgramAnalysis& analysis, Variable formal) {
    const Program& program = analysis.program();
    for (const dataflow::Store& store : analysis.facts().all<dataflow::Store>()) {
        const bool is_default = std::holds_alternative<Literal>(program.expressions[store.expression].node);
        if (store.variable == formal && !is_default) return std::nullopt;
    }
    for (ExpressionId id = 0; id < program.expressions.size(); ++id) {
        const auto* apply = std::get_if<Apply>(&program.expressions[id].node);
        if (apply == nullptr || !is_trigonometric(apply->operation)) continue;
        const auto* load = std::get_if<Load>(&program.expressions[program.operands_of(*apply).front()].node);
        if (load != nullptr && load->variable == formal) return id;
    }
    return std::nullopt;
}

bool is_near(double number, double wanted, double nearness) { return std::abs(number - wanted) < nearness; }
bool is_pi(double number) { return is_near(number, 3.14159265, 0.002); } // 3.14 is written, too
bool is_degrees_of_radian(double number) { return is_near(number, 57.29578, 0.005); }
bool is_radians_of_degree(double number) { return is_near(number, 0.01745329, 0.00002); }

/// What a value is multiplied with and divided by.
struct Factors {
    bool pi_above = false, pi_below = false;               ///< 3.14, or more exact
    bool half_turn_above = false, half_turn_below = false; ///< 180
    std::vector<ExpressionId> others;

    [[nodiscard]] bool make_radians() const { return pi_above && half_turn_below; }
    [[nodiscard]] bool make_degrees() const { return half_turn_above && pi_below; }

    /// Whether the number is one of the factors by which angles are converted.
    bool take(double number, bool below) {
        constexpr double half_turn = 180;
        const bool is_of_both = is_degrees_of_radian(number) || is_radians_of_degree(number);
        const bool is_pi_above = is_pi(number) ? !below : is_radians_of_degree(number) != below;
        const bool is_turn_above = number == half_turn ? !below : is_degrees_of_radian(number) != below;
        if (is_pi(number) || is_of_both) (is_pi_above ? pi_above : pi_below) = true;
        if (number == half_turn || is_of_both) (is_turn_above ? half_turn_above : half_turn_below) = true;
        return is_pi(number) || is_of_both || number == half_turn;
    }
};

class RadianConversions {
  public:
    explicit RadianConversions(const ProgramAnalysis& analysis)
        : analysis_(analysis)
        , program_(analysis.program()) {
        for (const dataflow::Read& read : analysis.facts().all<dataflow::Read>())
            reads_.emplace(read.expression, &read);
    }

    /// SIN, COS or TAN of what a factor made radians, here or in the assignment whose value it is.
    void look_at_argument(ExpressionId argument, std::vector<RadianUse>& found) const {
        const Factors factors = factors_of(argument);
        if (factors.make_radians()) {
            for (const ExpressionId other : factors.others)
                if (const dataflow::Read* read = read_of(other)) {
                    found.push_back({RadianFault::argument, read->effect, argument, argument});
                    return;
                }
            return;
        }
        const dataflow::Read* read = read_of(argument);
        const dataflow::Store* store = read == nullptr ? nullptr : queries::store_of(analysis_, read->value);
        if (store != nullptr && factors_of(store->expression).make_radians())
            found.push_back({RadianFault::argument, read->effect, store->expression, argument});
    }
    /// An assignment that makes degrees of what ASIN, ACOS or ATAN has given in degrees.
    void look_at_store(const dataflow::Store& store, std::vector<RadianUse>& found) const {
        if (const auto angle = degrees_in(store.expression, store.effect))
            found.push_back({RadianFault::result, store.effect, store.expression, *angle});
    }
    /// The same in a word, in the argument of a function or in a part of a calculation.
    void look_at_product(ExpressionId product, std::vector<RadianUse>& found) const {
        const auto angle = degrees_in(product, std::nullopt);
        const dataflow::Read* read = angle ? read_of(*angle) : nullptr;
        if (read != nullptr) found.push_back({RadianFault::result, read->effect, product, *angle});
    }
    /// A call that passes radians where the program counts in degrees.
    void look_at_call(const CallSite& site, std::vector<RadianUse>& found) const {
        for (const Argument& argument : program_.arguments_of(queries::call_of(program_, site.effect))) {
            const auto* formal = std::get_if<Variable>(&argument.given);
            const Factors factors = factors_of(argument.value);
            const bool is_angle =
                factors.make_radians() && std::ranges::any_of(factors.others, [&](ExpressionId other) {
                    return read_of(other) != nullptr;
                });
            const ProgramAnalysis* called =
                formal != nullptr && is_angle ? queries::called_program(analysis_, site) : nullptr;
            const auto function = called == nullptr ? std::nullopt : function_of_argument(*called, *formal);
            if (function)
                found.push_back({RadianFault::passed, site.effect, argument.value, *function, called});
        }
    }

  private:
    [[nodiscard]] Factors factors_of(ExpressionId id) const {
        Factors factors;
        collect(id, false, factors);
        return factors;
    }
    void collect(ExpressionId id, bool below, Factors& factors) const {
        if (const auto* literal = std::get_if<Literal>(&program_.expressions[id].node)) {
            factors.take(literal->value, below);
            return;
        }
        const dataflow::Read* read = read_of(id);
        const auto number = read == nullptr ? std::nullopt : read->value.constant();
        if (number && factors.take(*number, below)) return;
        const auto* apply = std::get_if<Apply>(&program_.expressions[id].node);
        if (!is_scaling(apply)) {
            factors.others.push_back(id);
            return;
        }
        const auto operands = program_.operands_of(*apply);
        collect(operands[0], below, factors);
        collect(operands[1], below != (apply->operation == Operation::divide), factors);
    }
    /// The angle in degrees of which the product makes them once more; `store`: that it is the value of.
    [[nodiscard]] std::optional<ExpressionId> degrees_in(ExpressionId product,
                                                         std::optional<EffectId> store) const {
        const Factors factors = factors_of(product);
        if (!factors.make_degrees()) return std::nullopt;
        const auto found = std::ranges::find_if(factors.others, [&](ExpressionId id) {
            if (const auto* apply = std::get_if<Apply>(&program_.expressions[id].node))
                return is_arc(apply->operation);
            const dataflow::Read* read = read_of(id);
            if (read == nullptr) return false;
            const auto operation = queries::operation_of(analysis_, read->value);
            return (operation && is_arc(*operation)) || is_only_set_to_angles(read->variable, store);
        });
        return found == factors.others.end() ? std::nullopt : std::optional(*found);
    }
    /// `#10=ATAN[#1]/[#2]`, `IF[#10GT180]THEN#10=#10-360`: whichever ran, the angle is in degrees.
    [[nodiscard]] bool is_only_set_to_angles(Variable variable, std::optional<EffectId> but_for) const {
        bool is_angle = false;
        for (const dataflow::Store& store : analysis_.facts().all<dataflow::Store>()) {
            if (store.variable != variable || store.effect == but_for) continue;
            const auto* apply = std::get_if<Apply>(&program_.expressions[store.expression].node);
            const bool is_from_arc = apply != nullptr && is_arc(apply->operation);
            if (!is_from_arc && !store.step) return false;
            is_angle |= is_from_arc;
        }
        return is_angle;
    }
    [[nodiscard]] const dataflow::Read* read_of(ExpressionId id) const {
        const auto read = reads_.find(id);
        return read == reads_.end() ? nullptr : read->second;
    }

    const ProgramAnalysis& analysis_;
    const Program& program_;
    std::unordered_map<ExpressionId, const dataflow::Read*> reads_;
};

/// Whether a factor by which angles are converted stands anywhere.
bool holds_factor(const Program& program) {
    return std::ranges::any_of(program.expressions, [](const Expression& expression) {
        const auto* literal = std::get_if<Literal>(&expression.node);
        return literal != nullptr && (is_pi(literal->value) || is_degrees_of_radian(literal->value) ||
                                      is_radians_of_degree(literal->value));
    });
}

/// The products and quotients that are neither a part of another one nor the value of an assignment.
std::vector<ExpressionId> products_in_calculations(const ProgramAnalysis& analysis) {
    const Program& program = analysis.program();
    std::vector<bool> is_told(program.expressions.size(), false);
    for (const dataflow::Store& store : analysis.facts().all<dataflow::Store>())
        is_told[store.expression] = true;
    for (const Expression& expression : program.expressions)
        if (const auto* apply = std::get_if<Apply>(&expression.node); is_scaling(apply))
            for (const ExpressionId operand : program.operands_of(*apply)) is_told[operand] = true;
    std::vector<ExpressionId> products;
    for (ExpressionId id = 0; id < program.expressions.size(); ++id)
        if (!is_told[id] && is_scaling(std::get_if<Apply>(&program.expressions[id].node)))
            products.push_back(id);
    return products;
}

} // namespace

std::vector<RadianUse> find_radians(const ProgramAnalysis& analysis) {
    const Program& program = analysis.program();
    std::vector<RadianUse> found;
    if (!holds_factor(program)) return found;
    const RadianConversions search(analysis);
    for (const dataflow::Store& store : analysis.facts().all<dataflow::Store>())
        search.look_at_store(store, found);
    for (const Expression& expression : program.expressions) {
        const auto* apply = std::get_if<Apply>(&expression.node);
        if (apply != nullptr && is_trigonometric(apply->operation))
            search.look_at_argument(program.operands_of(*apply).front(), found);
    }
    for (const ExpressionId product : products_in_calculations(analysis))
        search.look_at_product(product, found);
    for (const CallSite& site : analysis.calls()) search.look_at_call(site, found);
    return found;
}

} // namespace maclint::rules
