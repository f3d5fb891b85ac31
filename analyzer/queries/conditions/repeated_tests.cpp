//! Holds the parts of a condition against each other, and cases in a row.
#include "analyzer/queries/conditions/repeated_tests.hpp"

#include "analyzer/dataflow/domain/state.hpp"
#include "analyzer/dataflow/facts/condition.hpp"
#include "analyzer/program/block_view.hpp"
#include "analyzer/queries/conditions/conditions.hpp"
#include "analyzer/source/budget.hpp"

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>

namespace maclint::queries {
namespace {

bool joins_conditions(Operation operation) {
    return operation == Operation::all_of || operation == Operation::any_of || operation == Operation::one_of;
}

const Apply* logic_in(const Program& program, ExpressionId id) {
    const auto* apply = std::get_if<Apply>(&program.expressions[id].node);
    return apply != nullptr && joins_conditions(apply->operation) ? apply : nullptr;
}

/// The parts that one word of logic joins, in whatever brackets.
void collect_parts(const Program& program, Operation operation, ExpressionId id,
                   std::vector<ExpressionId>& parts) {
    const Apply* apply = logic_in(program, id);
    if (apply == nullptr || apply->operation != operation) return parts.push_back(id);
    for (const ExpressionId operand : program.operands_of(*apply))
        collect_parts(program, operation, operand, parts);
}

void compare_parts(const Program& program, EffectId effect, ExpressionId id,
                   std::vector<RepeatedTest>& found) {
    const Apply* apply = logic_in(program, id);
    if (apply == nullptr) return;
    std::vector<ExpressionId> parts;
    collect_parts(program, apply->operation, id, parts);
    for (auto second = parts.begin(); second != parts.end(); ++second) {
        const auto first = std::find_if(parts.begin(), second, [&](ExpressionId other) {
            return same_expression(program, other, *second);
        });
        if (first != second) found.push_back({effect, *first, *second, {}});
        compare_parts(program, effect, *second, found);
    }
}

dataflow::Key key(Variable variable) { return dataflow::key_of(variable); }

/// What an expression reads, looked up once for all who ask.
class Reads {
  public:
    Reads(const Program& program, ExpressionId expression) {
        collect(program, expression);
        std::ranges::sort(variables_, {}, key);
        variables_.erase(std::ranges::unique(variables_).begin(), variables_.end());
    }
    /// Whether it reads the variable, or may, through an index.
    [[nodiscard]] bool hold(Variable variable) const {
        return by_index_ || std::ranges::binary_search(variables_, key(variable), {}, key);
    }
    /// Of the expression, in expressions.
    [[nodiscard]] std::size_t size() const { return size_; }

  private:
    void collect(const Program& program, ExpressionId expression) {
        ++size_;
        const auto& node = program.expressions[expression].node;
        by_index_ = by_index_ || std::holds_alternative<LoadAt>(node);
        if (const auto* load = std::get_if<Load>(&node)) variables_.push_back(load->variable);
        if (const auto* apply = std::get_if<Apply>(&node))
            for (const ExpressionId operand : program.operands_of(*apply)) collect(program, operand);
    }

    std::vector<Variable> variables_; ///< sorted, each once
    bool by_index_ = false;
    std::size_t size_ = 0;
};

/// IF[…]THEN#1=…
struct Case {
    EffectId effect;
    ExpressionId condition;
    EffectId set;
    Variable variable;
    Reads asked, given; ///< by the condition, in the value
};

std::optional<Case> case_of(const Program& program, ItemId item) {
    const auto block = stored_block(program, item);
    if (!block || block->skip_levels != 0) return std::nullopt;
    // What it guards stands behind it among the effects of the block.
    const auto* guarded = block->effects.count == 0
                              ? nullptr
                              : std::get_if<Guarded>(&program.effects[block->effects.first].what);
    if (guarded == nullptr || guarded->effects.count != 1) return std::nullopt;
    const EffectId set = guarded->effects.first;
    const auto* assign = std::get_if<Assign>(&program.effects[set].what);
    const auto* variable = assign == nullptr ? nullptr : std::get_if<Variable>(&assign->target);
    if (variable == nullptr) return std::nullopt;
    return Case{block->effects.first,          guarded->condition,      set, *variable,
                {program, guarded->condition}, {program, assign->value}};
}

/// Whether the conditions are the same; of one of many comparisons each is looked at.
bool ask_the_same(const Program& program, const Case& a, const Case& b) {
    constexpr std::size_t looked_at_with_the_case = 8;
    return a.asked.size() == b.asked.size() && Budget::allows(a.asked.size() / looked_at_with_the_case) &&
           same_expression(program, a.condition, b.condition);
}

/// Of cases in a row the nearest before the last that asks the same and sets the same.
const Case* repeated_case(const Program& program, std::span<const Case> cases) {
    const Case& last = cases.back();
    if (last.given.hold(last.variable) || last.asked.hold(last.variable)) return nullptr;
    for (auto earlier = cases.rbegin() + 1; earlier != cases.rend(); ++earlier) {
        if (!Budget::allows() || earlier->asked.hold(earlier->variable)) return nullptr;
        if (earlier->variable == last.variable && ask_the_same(program, *earlier, last)) return &*earlier;
        if (last.asked.hold(earlier->variable) || earlier->asked.hold(last.variable) ||
            earlier->given.hold(last.variable))
            return nullptr;
    }
    return nullptr;
}

bool is_reached(const ProgramAnalysis& analysis, EffectId effect) {
    const auto node = analysis.graph().node_of(effect);
    return node && analysis.data().reached(*node);
}

void compare_cases(const ProgramAnalysis& analysis, std::vector<RepeatedTest>& found) {
    const Program& program = analysis.program();
    std::vector<Case> row;
    for (ItemId item = 0; item < program.items.size(); ++item) {
        auto now = case_of(program, item);
        if (!now || !is_reached(analysis, now->effect)) {
            row.clear();
            continue;
        }
        row.push_back(*std::move(now));
        if (const Case* earlier = repeated_case(program, row))
            found.push_back({row.back().effect, earlier->condition, row.back().condition, earlier->set});
    }
}

} // namespace

std::vector<RepeatedTest> find_repeated_tests(const ProgramAnalysis& analysis) {
    std::vector<RepeatedTest> found;
    for (const dataflow::Condition& condition : analysis.facts().all<dataflow::Condition>())
        compare_parts(analysis.program(), condition.effect, condition.expression, found);
    compare_cases(analysis, found);
    return found;
}

} // namespace maclint::queries
