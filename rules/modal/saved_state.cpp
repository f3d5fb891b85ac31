//! Follows copies back to what was read.
#include "rules/modal/saved_state.hpp"

#include <algorithm>

namespace maclint::rules {

const dataflow::Store* store_of(const ProgramAnalysis& analysis, const dataflow::Value& value) {
    const dataflow::Origin& origin = analysis.data().origin(value.origin);
    if (origin.kind != dataflow::Origin::Kind::effect) return nullptr;
    const auto stores = analysis.facts().at<dataflow::Store>(origin.id);
    return stores.empty() ? nullptr : &stores.front();
}

std::optional<CopySource> copy_source(const ProgramAnalysis& analysis, ExpressionId expression,
                                      const dataflow::Value& value) {
    constexpr int most_copies = 8;
    const Program& program = analysis.program();
    dataflow::Value now = value;
    for (int i = 0; i < most_copies; ++i) {
        const auto& node = program.expressions[expression].node;
        if (const auto* modal = std::get_if<LoadModal>(&node))
            return CopySource{expression, modal->group, nullptr};
        if (const auto* machine = std::get_if<LoadMachine>(&node))
            return CopySource{
                expression, {}, analysis.control().families[machine->family].find(machine->number)};
        if (!std::holds_alternative<Load>(node)) return std::nullopt;
        const dataflow::Store* store = store_of(analysis, now);
        if (store == nullptr) return std::nullopt;
        expression = store->expression;
        now = store->value;
    }
    return std::nullopt;
}

} // namespace maclint::rules
