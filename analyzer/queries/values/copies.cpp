//! Follows copies back to what was read.
#include "analyzer/queries/values/copies.hpp"

#include "analyzer/dataflow/facts/with_value.hpp"
#include "analyzer/program/tables.hpp"
#include "analyzer/queries/values/origins.hpp"

#include <algorithm>

namespace maclint::queries {

bool is_same_value(const dataflow::Value& a, const dataflow::Value& b) { return a.symbol == b.symbol; }

const dataflow::Store* store_of(const ProgramAnalysis& analysis, const dataflow::Value& value) {
    const auto effect = effect_of_origin(analysis, value.origin);
    if (!effect) return nullptr;
    const auto stores = analysis.facts().at<dataflow::Store>(*effect);
    return stores.empty() ? nullptr : &stores.front();
}

const dataflow::Store* only_store_of(const ProgramAnalysis& analysis, Variable variable,
                                     const dataflow::Value& value) {
    if (const dataflow::Store* store = store_of(analysis, value)) return store;
    if (analysis.data().table().symbols[value.symbol].kind() != dataflow::Symbol::Kind::joined)
        return nullptr;
    const auto stores = analysis.facts().about<dataflow::Store>(variable);
    return stores.size() == 1 ? stores.front() : nullptr;
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

const dataflow::ModalRead* modal_read_of(const ProgramAnalysis& analysis, const dataflow::Store& store) {
    const auto reads = analysis.facts().at<dataflow::ModalRead>(store.effect);
    const auto read = std::ranges::find(reads, store.expression, &dataflow::ModalRead::expression);
    return read == reads.end() ? nullptr : &*read;
}

std::optional<GroupId> saved_group(const ProgramAnalysis& analysis, const dataflow::Store& store) {
    const auto* load = std::get_if<LoadModal>(&analysis.program().expressions[store.expression].node);
    return load == nullptr ? std::nullopt : std::optional(load->group);
}

bool saves_group(const ProgramAnalysis& analysis, GroupId group) {
    return std::ranges::any_of(analysis.facts().all<dataflow::Store>(), [&](const dataflow::Store& store) {
        return saved_group(analysis, store) == group;
    });
}

bool is_copied_into(const ProgramAnalysis& analysis, Variable variable, const dataflow::Value& value) {
    return dataflow::any_with_value<dataflow::Store>(analysis.facts(), variable, value.symbol,
                                                     [](const dataflow::Store&) { return true; });
}

} // namespace maclint::queries
