//! Gathers what keeps positions, and which words move by it.
#include "rules/variables/crossed_axes_words_finder.hpp"

#include "analyzer/dataflow/domain/state.hpp"
#include "analyzer/program/machine_words.hpp"
#include "analyzer/program/tables.hpp"
#include "analyzer/queries/values/positions.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <vector>

namespace maclint::rules {
namespace {

/// A position that a variable gets.
struct Kept {
    EffectId store;
    Variable variable;
    const VariableRange* range;
    std::int32_t number; ///< 5041

    [[nodiscard]] std::int32_t axis() const { return number - range->first; } ///< from 0 on
};

std::vector<Kept> kept_positions(const Program& program) {
    std::vector<Kept> found;
    for (EffectId id = 0; id < program.effects.size(); ++id) {
        const auto* assign = std::get_if<Assign>(&program.effects[id].what);
        const auto* variable = assign == nullptr ? nullptr : std::get_if<Variable>(&assign->target);
        const VariableRange* range =
            variable == nullptr ? nullptr : queries::position_read(program, assign->value);
        if (range == nullptr) continue;
        const auto& load = std::get<LoadMachine>(program.expressions[assign->value].node);
        found.push_back({id, *variable, range, load.number});
    }
    return found;
}

/// The axes that words move by a variable, with the first such word.
struct Uses {
    std::set<char> axes;
    Span first;
};
using UsesOfVariables = std::map<dataflow::Key, Uses>;

/// The variables that the sum is made of.
void note_sum(const Program& program, ExpressionId id, const Word& word, UsesOfVariables& uses) {
    const auto& node = program.expressions[id].node;
    if (const auto* load = std::get_if<Load>(&node)) {
        Uses& of = uses.try_emplace(dataflow::key_of(load->variable), Uses{{}, word.span}).first->second;
        of.axes.insert(word.address.front());
        return;
    }
    const auto* sum = std::get_if<Apply>(&node);
    if (sum == nullptr || (sum->operation != Operation::add && sum->operation != Operation::subtract)) return;
    for (const ExpressionId operand : program.operands_of(*sum)) note_sum(program, operand, word, uses);
}

UsesOfVariables uses_in_words(const Program& program) {
    UsesOfVariables uses;
    for (const Word& word : program.words) {
        const auto* id = std::get_if<ExpressionId>(&word.value);
        if (id != nullptr && word.address.size() == 1) note_sum(program, *id, word, uses);
    }
    return uses;
}

bool moves_only(const Uses& uses, char axis) { return uses.axes.size() == 1 && uses.axes.contains(axis); }

} // namespace

std::vector<PlaceForAnotherAxis> find_places_for_other_axes(const Program& program) {
    std::vector<PlaceForAnotherAxis> found;
    const std::vector<Kept> kept = kept_positions(program);
    if (kept.size() < 2 || program.control->machine_words == nullptr) return found;
    const AxisLetters& letters = program.control->machine_words->axes;
    const UsesOfVariables uses = uses_in_words(program);
    const auto moves = [&](const Kept& one, std::size_t axis) {
        const auto of = uses.find(dataflow::key_of(one.variable));
        return of != uses.end() && moves_only(of->second, letters[axis]);
    };
    std::map<std::int32_t, std::vector<const Kept*>> twins; ///< by position: two that move its own axis
    for (const Kept& one : kept) {
        const auto axis = static_cast<std::size_t>(one.axis());
        std::vector<const Kept*>& of = twins[one.number];
        if (axis < letters.size() && of.size() < 2 && moves(one, axis) &&
            (of.empty() || !(of.front()->variable == one.variable)))
            of.push_back(&one);
    }
    for (const Kept& one : kept) {
        const auto axis = static_cast<std::size_t>(one.axis());
        const std::vector<const Kept*>& of = twins.at(one.number);
        const auto twin =
            std::ranges::find_if(of, [&](const Kept* other) { return !(other->variable == one.variable); });
        if (axis >= letters.size() || twin == of.end()) continue;
        for (std::size_t other = 0; other < letters.size(); ++other)
            if (other != axis && moves(one, other))
                found.push_back({one.store,
                                 one.variable,
                                 uses.at(dataflow::key_of(one.variable)).first,
                                 (*twin)->variable,
                                 {one.range->space, one.range->first + static_cast<std::int32_t>(other)},
                                 letters[axis]});
    }
    return found;
}

} // namespace maclint::rules
