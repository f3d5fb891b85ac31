//! Looks at what the tested variable was set to, and at what the test guards.
#include "analyzer/queries/dead_guards.hpp"

#include <algorithm>

namespace maclint::queries {
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

/// #100=#400 after a test of #400: nothing was calculated, and yet it is known to be set.
bool is_tested_copy(const ProgramAnalysis& analysis, const dataflow::Value& value) {
    using Kind = dataflow::Symbol::Kind;
    const Kind kind = analysis.data().table().symbols[value.symbol].kind;
    return kind == Kind::entry || kind == Kind::opaque;
}

} // namespace

bool is_harmless_guard(const ProgramAnalysis& analysis, const dataflow::Comparison& test, Variable variable) {
    if (is_tested_copy(analysis, test.left)) return true;
    const Guarded* guarded = guarded_by(analysis.program(), test);
    return guarded != nullptr && only_sets(analysis.program(), *guarded, variable);
}

const dataflow::Store* last_store_before(const ProgramAnalysis& analysis, Variable variable,
                                         flow::NodeId node) {
    const dataflow::Store* last = nullptr;
    for (const dataflow::Store& store : analysis.facts().all<dataflow::Store>())
        if (store.variable == variable && store.node < node) last = &store;
    return last;
}

std::optional<Variable> keeper_of_argument(const ProgramAnalysis& analysis, Variable variable,
                                           flow::NodeId before) {
    const auto& symbols = analysis.data().table().symbols;
    for (const dataflow::Store& store : analysis.facts().all<dataflow::Store>()) {
        const dataflow::Symbol& symbol = symbols[store.value.symbol];
        const bool copy =
            symbol.kind == dataflow::Symbol::Kind::entry && symbol.a == dataflow::key_of(variable);
        if (copy && store.variable != variable && store.node < before) return store.variable;
    }
    return std::nullopt;
}

} // namespace maclint::queries
