//! Codes that switch a state are asked of the state, other words of the blocks that hold them.
#include "analyzer/machine/demands.hpp"

#include <algorithm>

namespace maclint::machine {
namespace {

bool is_code(const DemandedBlock::Word& word) { return word.letter == 'G' || word.letter == 'M'; }

bool contains(std::span<const double> numbers, double number) {
    return std::ranges::find(numbers, number) != numbers.end();
}

/// The state that a code of a modal group, or one of the coolant, switches; nullptr: it switches none.
const Known* switched_by(const DemandedBlock::Word& word, const State& state, const ControlModel& control) {
    if (!is_code(word)) return nullptr;
    const auto group = control.group_of(word.letter, *word.number);
    if (group && control.groups[*group].role != ModalRole::other)
        return &state.of(control.groups[*group].role);
    const MachineWords& machine = *control.machine_words;
    const bool is_of_coolant = word.letter == 'M' && (contains(machine.coolant_on, *word.number) ||
                                                      *word.number == machine.coolant_off);
    return is_of_coolant ? &state.coolant : nullptr;
}

/// Whether the code switches its state off, or asks for what no program needs to say.
bool switches_off(const DemandedBlock::Word& word, const ControlModel& control) {
    const auto group = control.group_of(word.letter, *word.number);
    if (!group) return *word.number == control.machine_words->coolant_off;
    return control.groups[*group].cancel == *word.number;
}

/// Whether nothing turns under the code in force, as under M19.
bool is_idle(const DemandedBlock::Word& word, const Known& now, const ControlModel& control) {
    const auto group = control.group_of(word.letter, *word.number);
    return group && std::ranges::any_of(control.idle, [&](const Idle& idle) {
               return idle.under.group == *group && now.is(idle.under.code);
           });
}

bool stands_in(const Words& words, const DemandedBlock::Word& word) {
    if (is_code(word)) return contains(word.letter == 'G' ? words.g_codes() : words.m_codes(), *word.number);
    const auto number = words.number(word.letter);
    return word.number ? number && number->value == *word.number : words.has(word.letter);
}

} // namespace

bool says(const Words& words, const State& after, const ControlModel& control,
          const DemandedBlock& demanded) {
    bool has_own_word = false;
    const bool holds_all = std::ranges::all_of(demanded.words, [&](const DemandedBlock::Word& word) {
        const bool stands_there = stands_in(words, word);
        has_own_word |= stands_there;
        const Known* switched = switched_by(word, after, control);
        return stands_there || (switched != nullptr && switched->is(*word.number));
    });
    return holds_all && has_own_word;
}

std::optional<Missed> missed(const Step& step, const State& state, const ControlModel& control,
                             std::size_t demanded) {
    const DemandedBlock& block = control.demands->blocks[demanded];
    if (says(step.words, step.after, control, block)) return std::nullopt;
    const bool is_said = (state.demands_met >> demanded & 1) != 0;
    const bool are_states = std::ranges::all_of(block.words, [&](const DemandedBlock::Word& word) {
        return switched_by(word, state, control) != nullptr;
    });
    if (block.place == DemandedBlock::Place::start || !are_states)
        return is_said ? std::nullopt : std::optional(Missed{});
    std::optional<Missed> missed;
    for (const DemandedBlock::Word& word : block.words) {
        const Known& now = *switched_by(word, state, control);
        const bool is_off = switches_off(word, control);
        if (now.is(*word.number) || now.kind == Known::Kind::unknown) continue;
        if (is_off && (now.is_callers() || is_idle(word, now, control))) continue;
        if (!missed) missed.emplace();
        if (missed->in_force == nullptr && now.is_known()) missed = {&now, word.letter};
    }
    return missed;
}

} // namespace maclint::machine
