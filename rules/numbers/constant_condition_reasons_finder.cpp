//! One look at all stores and conditions.
#include "rules/numbers/constant_condition_reasons_finder.hpp"

#include "analyzer/dataflow/facts/comparison.hpp"
#include "analyzer/dialect/ascii.hpp"
#include "analyzer/queries/conditions/conditions.hpp"
#include "analyzer/queries/values/calculations.hpp"
#include "analyzer/queries/values/copies.hpp"
#include "analyzer/queries/values/origins.hpp"

#include <algorithm>
#include <optional>
#include <utility>
#include <variant>

namespace maclint::rules {
namespace {

/// Tests before a condition that are looked at for what decides it.
constexpr std::size_t most_tests_before = 1000;
/// Nodes on the paths from all of these to the condition.
constexpr std::size_t most_nodes_before = 2500;

const Guarded* guarded_by(const Program& program, EffectId effect) {
    return std::get_if<Guarded>(&program.effects[effect].what);
}

std::optional<Label> jump_target(const Program& program, EffectId effect) {
    const Guarded* guarded = guarded_by(program, effect);
    if (guarded == nullptr || guarded->effects.count != 1) return std::nullopt;
    const auto* jump = std::get_if<Jump>(&program.effects[guarded->effects.first].what);
    return jump == nullptr ? std::nullopt : flow::constant_target(program, jump->target);
}

/// The text of what the condition guards, without blanks.
std::string guarded_text(const Program& program, EffectId effect) {
    const Guarded* guarded = guarded_by(program, effect);
    if (guarded == nullptr || guarded->effects.count != 1) return {};
    const Span span = program.effects[guarded->effects.first].span;
    return without_blanks(program.slice(span));
}

struct Sides {
    bool vacant = false; ///< one has never been set
    bool open = true;    ///< no comparison is decided by itself: #1LT8 OR #1GT6
    bool near = false;   ///< one may be decided otherwise by the rounding of a calculated value
    bool same = false;   ///< one has a single variable on both sides: #1GE#1
};

/// The variable that is all of one side.
std::optional<Variable> variable_of_side(const Program& program, ExpressionId side) {
    const auto* load = std::get_if<Load>(&program.expressions[side].node);
    return load == nullptr ? std::nullopt : std::optional(load->variable);
}

/// 1-#1*#1/900, which is never below 0 but by its last digit, is asked for LT0 in front of SQRT. An amount is
/// not below 0 by any digit.
bool is_rounding_away(const ProgramAnalysis& analysis, const dataflow::Comparison& comparison) {
    const dataflow::Value& left = comparison.left;
    const dataflow::Value& right = comparison.right;
    const bool rounded =
        left.exactness == dataflow::Exactness::rounded || right.exactness == dataflow::Exactness::rounded;
    const auto may_reach = [&](const dataflow::Value& low, const dataflow::Value& high) {
        return low.low == high.high &&
               !(low.low == 0 && queries::operation_of(analysis, low) == Operation::absolute);
    };
    return rounded && (may_reach(left, right) || may_reach(right, left));
}

Sides sides_of(const ProgramAnalysis& analysis, const dataflow::Condition& condition) {
    Sides sides;
    for (const auto& comparison : analysis.facts().at<dataflow::Comparison>(condition.effect)) {
        sides.open &= comparison.truth.can_hold && comparison.truth.can_fail;
        sides.near |= is_rounding_away(analysis, comparison);
        const auto left = variable_of_side(analysis.program(), comparison.left_expression);
        sides.same |= comparison.left_expression != comparison.right_expression && left &&
                      left == variable_of_side(analysis.program(), comparison.right_expression);
        for (const dataflow::Value* value : {&comparison.left, &comparison.right})
            sides.vacant |= value->vacancy == dataflow::Vacancy::vacant;
    }
    return sides;
}

} // namespace

DeliberateConditions::DeliberateConditions(const ProgramAnalysis& analysis)
    : analysis_(analysis)
    , settings_(analysis) {
    const Program& program = analysis.program();
    for (const dataflow::Condition& condition : analysis.facts().all<dataflow::Condition>()) {
        if (const auto target = jump_target(program, condition.effect))
            first_tests_.try_emplace(*target, condition.node);
        else if (std::string text = guarded_text(program, condition.effect); !text.empty())
            ++guarded_[std::move(text)];
    }
}

bool DeliberateConditions::may_be_meant(const dataflow::Condition& condition,
                                        const std::optional<queries::GuardBefore>& guard) const {
    const Sides sides = sides_of(analysis_, condition);
    const Program& program = analysis_.program();
    if (guard && guard->same &&
        (jump_target(program, condition.effect) ||
         guarded_text(program, guard->effect) == guarded_text(program, condition.effect)))
        return false;
    if (sides.open || sides.same) return false;
    const bool asks_of_vacant = exemptions::condition_on_vacancy.is_on() && sides.vacant;
    const bool asks_for_settings = !guard && exemptions::condition_on_settings.is_on();
    if (!guard && sides.near) return true;
    if (asks_for_settings && settings_.is_all_that_is_read(condition.expression, condition.effect))
        return true;
    if (!guard && asks_of_vacant) return true; // MAC209's, or a case that is left over
    if (leaves_nothing_to_run(condition)) return false;
    if (exemptions::jump_to_same_place.is_on() && repeats_another(condition)) return true;
    if (exemptions::same_block_guarded_again.is_on() && does_what_another_does(condition)) return true;
    if (asks_for_settings && settings_.is_read(condition.effect)) return true;
    if (!guard && asks_for_a_count(condition)) return false;
    // What is left over after all other cases were tested may be tested once more.
    return asks_of_vacant || (exemptions::last_case_tested.is_on() && condition.truth.can_hold);
}

/// What has just been counted is always the same number where the jump leads back in front of its first one.
/// Where a number stands twice, that is why the jump leads there.
bool DeliberateConditions::asks_for_a_count(const dataflow::Condition& condition) const {
    const auto& labels = analysis_.graph().labels;
    const bool stands_twice =
        std::ranges::adjacent_find(labels, {}, &flow::LabelledBlock::label) != labels.end();
    return !stands_twice &&
           std::ranges::any_of(analysis_.facts().at<dataflow::Read>(condition.effect),
                               [&](const dataflow::Read& read) {
                                   const dataflow::Store* store = queries::store_of(analysis_, read.value);
                                   return store != nullptr && store->step && read.value.constant();
                               });
}

/// An earlier test sends to the same place: the second is not needed, but does no harm.
bool DeliberateConditions::repeats_another(const dataflow::Condition& condition) const {
    const auto target = jump_target(analysis_.program(), condition.effect);
    return target && first_tests_.at(*target) < condition.node;
}

/// IF[#6GT1]GOTO3, IF[#6NE4]GOTO3: one of the two is always true, and what stands in front of N3 never runs.
bool DeliberateConditions::leaves_nothing_to_run(const dataflow::Condition& condition) const {
    if (!condition.truth.can_hold || !repeats_another(condition)) return false;
    const auto& graph = analysis_.graph();
    std::optional<flow::NodeId> after, target;
    for (const flow::EdgeId id : graph.out[condition.node]) {
        const flow::Edge& edge = graph.edges[id];
        if (edge.condition) (edge.holds ? target : after) = edge.to;
    }
    return after && !analysis_.data().reached(*after) && after != target;
}

/// IF[#6LT54]THEN#31=-1, IF[#6LT55]THEN#31=-1: one of the two is not needed, but does no harm.
bool DeliberateConditions::does_what_another_does(const dataflow::Condition& condition) const {
    if (condition.truth.can_hold) return false;
    const auto found = guarded_.find(guarded_text(analysis_.program(), condition.effect));
    return found != guarded_.end() && found->second > 1;
}

Reason reason_for(const ProgramAnalysis& analysis, const dataflow::Condition& condition,
                  const std::optional<queries::GuardBefore>& guard) {
    const Program& program = analysis.program();
    const auto tested = [&](ExpressionId earlier) {
        return Reason{guard && guard->same ? Reason::Kind::same_test : Reason::Kind::test,
                      {},
                      0,
                      program.expressions[earlier].span,
                      earlier};
    };
    if (guard) return tested(guard->condition);
    const Sides sides = sides_of(analysis, condition);
    if (sides.same) return {Reason::Kind::same_sides, {}, 0, {}, {}};
    if (sides.open) return {Reason::Kind::itself, {}, 0, {}, {}};
    for (const dataflow::Read& read : analysis.facts().at<dataflow::Read>(condition.effect)) {
        const auto number = read.value.constant();
        const auto set = queries::effect_of_origin(analysis, read.value.origin);
        if (number && set)
            return {Reason::Kind::number, read.variable, *number, program.effects[*set].span, {}};
    }
    const auto comparisons = analysis.facts().all<dataflow::Comparison>();
    auto other = std::ranges::lower_bound(comparisons, condition.node, {}, &dataflow::Comparison::node);
    std::size_t nodes_left = most_nodes_before;
    for (std::size_t i = 0; i < most_tests_before && nodes_left > 0 && other != comparisons.begin(); ++i) {
        --other;
        if (queries::decides(analysis, *other, condition, nodes_left)) return tested(other->expression);
    }
    return {Reason::Kind::unknown, {}, 0, {}, {}};
}

} // namespace maclint::rules
