//! Lays the executed sections of a program out.
#include "analyzer/execution/layout.hpp"

#include <algorithm>
#include <cassert>

namespace maclint::execution {

Layout::Layout(const Program& program, const flow::Regions& regions)
    : program_(program)
    , regions_(regions)
    , within_(program.effects.size()) {
    for (const Section& section : program.sections) {
        if (section.executed == Section::Executed::never) continue;
        for_each_block(program, section, [&](const BlockView& block) {
            index(block.effects, steps_.size(), std::nullopt);
            steps_.push_back({block, {}});
            if (block.effects.count != 0) return; // they say what it sets
            for (const BlockSetting& setting : block.settings)
                steps_.back().settings.push_back({setting.group, *setting.value});
        });
    }
}

void Layout::index(Slice effects, std::size_t step, std::optional<EffectId> guard) {
    const EffectId end = effects.first + effects.count;
    for (EffectId id = effects.first; id < end; ++id) {
        within_[id] = Within{step, end, guard};
        if (const auto* guarded = std::get_if<Guarded>(&program_.effects[id].what))
            index(guarded->effects, step, id);
    }
}

std::optional<std::size_t> Layout::find(const Label& label, std::size_t from, LabelSearch search) const {
    const auto has_it = [&](std::size_t step) {
        if (const auto* name = std::get_if<BlockName>(&label)) return steps_[step].block.name == *name;
        return steps_[step].block.number == std::get<std::int64_t>(label);
    };
    const bool own_first = search == LabelSearch::forward_then_top;
    if (search != LabelSearch::backward)
        for (std::size_t step = own_first ? from : from + 1; step < steps_.size(); ++step)
            if (has_it(step)) return step;
    if (search == LabelSearch::forward_then_top)
        for (std::size_t step = 0; step < from; ++step)
            if (has_it(step)) return step;
    if (search == LabelSearch::backward || search == LabelSearch::forward_then_backward)
        for (std::size_t step = from + 1; step-- > 0;)
            if (has_it(step)) return step;
    return std::nullopt;
}

std::size_t Layout::step_of(EffectId effect) const {
    assert(within_[effect]);
    return within_[effect]->step;
}

Position Layout::after(EffectId effect) const {
    assert(within_[effect]);
    const Within& within = *within_[effect];
    if (effect + 1 < within.end) return {within.step, effect + 1};
    if (within.guard) return after(*within.guard);
    return {within.step + 1, std::nullopt};
}

const flow::Region* Layout::region_of(EffectId effect) const {
    const auto id = regions_.with(effect);
    if (!id) return nullptr;
    const flow::Region& region = regions_.all[*id];
    // Without its end, or crossing another, it is read as plain text: it is unknown what the control does.
    return region.close && !region.crossed ? &region : nullptr;
}

} // namespace maclint::execution
