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

bool is_pi(double number) {
    constexpr double pi = 3.14159265, nearness = 0.002; // 3.14 is written, too
    return std::abs(number - pi) < nearness;
}

/// What a value is multiplied with and divided by.
struct Factors {
    bool pi_above = false, pi_below = false;               ///< 3.14, or more exact
    bool half_turn_above = false, half_turn_below = false; ///< 180
    std::vector<ExpressionId> others;

    [[nodiscard]] bool make_radians() const { return pi_above && half_turn_below; }
    [[nodiscard]] bool make_degrees() const { return half_turn_above && pi_below; }
};

void collect(const Program& program, ExpressionId id, bool below, Factors& factors) {
    constexpr double half_turn = 180;
    if (const auto* literal = std::get_if<Literal>(&program.expressions[id].node)) {
        if (is_pi(literal->value)) (below ? factors.pi_below : factors.pi_above) = true;
        if (literal->value == half_turn) (below ? factors.half_turn_below : factors.half_turn_above) = true;
        return;
    }
    const auto* apply = std::get_if<Apply>(&program.expressions[id].node);
    if (apply == nullptr ||
        (apply->operation != Operation::multiply && apply->operation != Operation::divide)) {
        factors.others.push_back(id);
        return;
    }
    const auto operands = program.operands_of(*apply);
    collect(program, operands[0], below, factors);
    collect(program, operands[1], below != (apply->operation == Operation::divide), factors);
}

Factors factors_of(const Program& program, ExpressionId id) {
    Factors factors;
    collect(program, id, false, factors);
    return factors;
}

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
        const Factors factors = factors_of(program_, argument);
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
        if (store != nullptr && factors_of(program_, store->expression).make_radians())
            found.push_back({RadianFault::argument, read->effect, store->expression, argument});
    }
    /// An assignment that makes degrees of what ASIN, ACOS or ATAN has given in degrees.
    void look_at_store(const dataflow::Store& store, std::vector<RadianUse>& found) const {
        if (const auto angle = degrees_in(store))
            found.push_back({RadianFault::result, store.effect, store.expression, *angle});
    }

  private:
    [[nodiscard]] std::optional<ExpressionId> degrees_in(const dataflow::Store& store) const {
        const Factors factors = factors_of(program_, store.expression);
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

bool holds_pi(const Program& program) {
    return std::ranges::any_of(program.expressions, [](const Expression& expression) {
        const auto* literal = std::get_if<Literal>(&expression.node);
        return literal != nullptr && is_pi(literal->value);
    });
}

} // namespace

std::vector<RadianUse> find_radians(const ProgramAnalysis& analysis) {
    const Program& program = analysis.program();
    std::vector<RadianUse> found;
    if (!holds_pi(program)) return found;
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
