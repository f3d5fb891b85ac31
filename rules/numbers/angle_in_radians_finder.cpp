//! Looks for factors of pi and 180 on the way into and out of the functions of angles.
#include "rules/numbers/angle_in_radians_finder.hpp"

#include "analyzer/dataflow/facts/read.hpp"
#include "analyzer/dataflow/facts/store.hpp"
#include "analyzer/queries/values/calculations.hpp"
#include "analyzer/queries/values/copies.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <unordered_map>
#include <variant>

namespace maclint::rules {
namespace {

bool is_arc(Operation operation) {
    return operation == Operation::arc_sine || operation == Operation::arc_cosine ||
           operation == Operation::arc_tangent || operation == Operation::arc_tangent_of_two;
}

bool is_trigonometric(Operation operation) {
    return operation == Operation::sine || operation == Operation::cosine || operation == Operation::tangent;
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
        if (const auto angle = degrees_in(store))
            found.push_back({RadianFault::result, store.effect, store.expression, *angle});
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
        if (apply == nullptr ||
            (apply->operation != Operation::multiply && apply->operation != Operation::divide)) {
            factors.others.push_back(id);
            return;
        }
        const auto operands = program_.operands_of(*apply);
        collect(operands[0], below, factors);
        collect(operands[1], below != (apply->operation == Operation::divide), factors);
    }
    [[nodiscard]] std::optional<ExpressionId> degrees_in(const dataflow::Store& store) const {
        const Factors factors = factors_of(store.expression);
        if (!factors.make_degrees()) return std::nullopt;
        const auto found = std::ranges::find_if(factors.others, [&](ExpressionId id) {
            if (const auto* apply = std::get_if<Apply>(&program_.expressions[id].node))
                return is_arc(apply->operation);
            const dataflow::Read* read = read_of(id);
            const auto operation =
                read == nullptr ? std::nullopt : queries::operation_of(analysis_, read->value);
            return operation && is_arc(*operation);
        });
        return found == factors.others.end() ? std::nullopt : std::optional(*found);
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
    return found;
}

} // namespace maclint::rules
