//! Looks at what the tested variable was set to, and at what the test guards.
#include "rules/variables/vacancy_test_never_true_finder.hpp"

#include <algorithm>
#include <iterator>

namespace maclint::rules {
namespace {

const Guarded* guarded_by(const Program& program, const dataflow::Comparison& test) {
    return std::get_if<Guarded>(&program.effects[test.effect].what);
}

/// IF[#6EQ#0]THEN#6=0
bool only_sets(const Program& program, const Guarded& guarded, Variable variable) {
    return std::ranges::all_of(program.effects_in(guarded.effects), [&](const Effect& effect) {
        const auto* assign = std::get_if<Assign>(&effect.what);
        const auto* target = assign == nullptr ? nullptr : std::get_if<Variable>(&assign->target);
        return target != nullptr && *target == variable;
    });
}

bool is_zero(const Program& program, ExpressionId expression) {
    const auto* literal = std::get_if<Literal>(&program.expressions[expression].node);
    return literal != nullptr && literal->value == 0;
}

/// #100=#400 after a test of #400: nothing was calculated, and yet it is known to be set.
bool is_tested_copy(const ProgramAnalysis& analysis, const dataflow::Value& value) {
    using Kind = dataflow::Symbol::Kind;
    const Kind kind = analysis.data().table().symbols[value.symbol].kind();
    return kind == Kind::entry || kind == Kind::opaque;
}

} // namespace

bool is_harmless_guard(const ProgramAnalysis& analysis, const dataflow::Comparison& test, Variable variable) {
    if (is_tested_copy(analysis, test.left)) return true;
    const Guarded* guarded = guarded_by(analysis.program(), test);
    return guarded != nullptr && only_sets(analysis.program(), *guarded, variable);
}

bool sets_zero(const ProgramAnalysis& analysis, const dataflow::Comparison& test, Variable variable) {
    const Program& program = analysis.program();
    const Guarded* guarded = guarded_by(program, test);
    return exemptions::zero_made_sure.is_on() && guarded != nullptr &&
           only_sets(program, *guarded, variable) &&
           std::ranges::all_of(program.effects_in(guarded->effects), [&](const Effect& effect) {
               return is_zero(program, std::get<Assign>(effect.what).value);
           });
}

const dataflow::Store* last_store_before(const ProgramAnalysis& analysis, Variable variable,
                                         flow::NodeId node) {
    const auto stores = analysis.facts().about<dataflow::Store>(variable);
    const auto after = std::ranges::lower_bound(stores, node, {}, &dataflow::Store::node);
    return after == stores.begin() ? nullptr : *std::prev(after);
}

KeptArguments::FirstCopies KeptArguments::find_first_copies() const {
    FirstCopies copies;
    const auto& symbols = analysis_.data().table().symbols;
    for (const dataflow::Store& store : analysis_.facts().all<dataflow::Store>()) {
        const dataflow::Symbol& symbol = symbols[store.value.symbol];
        if (symbol.kind() == dataflow::Symbol::Kind::entry &&
            symbol.key() != dataflow::key_of(store.variable))
            copies.try_emplace(symbol.key(), &store);
    }
    return copies;
}

std::optional<Variable> KeptArguments::keeper_of(Variable variable, flow::NodeId before) {
    if (!first_copies_) first_copies_ = find_first_copies();
    const auto copy = first_copies_->find(dataflow::key_of(variable));
    if (copy == first_copies_->end() || copy->second->node >= before) return std::nullopt;
    return copy->second->variable;
}

} // namespace maclint::rules
