//! Looks at the words of blocks that move.
#include "rules/numbers/ratio_as_length_finder.hpp"

#include "analyzer/program/block_view.hpp"
#include "analyzer/program/tables.hpp"

#include <algorithm>
#include <cstdint>
#include <span>
#include <string_view>
#include <unordered_map>
#include <variant>

namespace maclint::rules {
namespace {

enum class Kind : std::uint8_t { other, ratio, angle };

Kind kind_of(Operation operation) {
    switch (operation) {
    case Operation::sine:
    case Operation::cosine:
    case Operation::tangent: return Kind::ratio;
    case Operation::arc_sine:
    case Operation::arc_cosine:
    case Operation::arc_tangent:
    case Operation::arc_tangent_of_two: return Kind::angle;
    default: return Kind::other;
    }
}

/// What the expression is, signs and brackets aside.
Kind kind_of(const Program& program, ExpressionId id) {
    const auto* apply = std::get_if<Apply>(&program.expressions[id].node);
    if (apply == nullptr) return Kind::other;
    return apply->operation == Operation::negate ? kind_of(program, program.operands_of(*apply).front())
                                                 : kind_of(apply->operation);
}

/// What the only assignment of each variable stores in it; other where it has several, or only some runs come
/// by it.
std::unordered_map<Variable, Kind, VariableHash> kinds_of_variables(const Program& program) {
    std::unordered_map<Variable, Kind, VariableHash> kinds;
    std::vector<bool> guarded(program.effects.size(), false);
    for (const Effect& effect : program.effects)
        if (const auto* guard = std::get_if<Guarded>(&effect.what))
            std::fill_n(guarded.begin() + guard->effects.first, guard->effects.count, true);
    for (EffectId id = 0; id < program.effects.size(); ++id) {
        const auto* assign = std::get_if<Assign>(&program.effects[id].what);
        const auto* target = assign == nullptr ? nullptr : std::get_if<Variable>(&assign->target);
        if (target == nullptr) continue;
        const Kind kind = guarded[id] ? Kind::other : kind_of(program, assign->value);
        const auto [known, first] = kinds.try_emplace(*target, kind);
        if (!first) known->second = Kind::other;
    }
    std::erase_if(kinds, [](const auto& known) { return known.second == Kind::other; });
    return kinds;
}

/// The variable that the word is, its sign aside.
const Load* variable_in(const Program& program, ExpressionId id) {
    const auto* apply = std::get_if<Apply>(&program.expressions[id].node);
    if (apply != nullptr && apply->operation == Operation::negate)
        return variable_in(program, program.operands_of(*apply).front());
    return std::get_if<Load>(&program.expressions[id].node);
}

bool may_be_polar(const Program& program) {
    const auto polar = program.control->group_with(ModalRole::polar_coordinates);
    bool found = false;
    for_each_block(program, [&](const BlockView& block) {
        found |= std::ranges::any_of(block.settings,
                                     [&](const BlockSetting& setting) { return setting.group == polar; });
        return !found;
    });
    return found;
}

/// Whether the block moves, and calls nothing that its words could be for.
bool is_plain_move(const Program& program, const StoredBlock& block) {
    const auto effects = program.effects_in(block.effects);
    const auto is_move = [](const Effect& effect) {
        const auto* motion = std::get_if<Motion>(&effect.what);
        return motion != nullptr && !motion->to_reference;
    };
    const auto is_call = [](const Effect& effect) { return std::holds_alternative<Call>(effect.what); };
    return std::ranges::any_of(effects, is_move) && std::ranges::none_of(effects, is_call);
}

} // namespace

std::vector<AngleAsLength> find_angles_as_lengths(const Program& program) {
    constexpr std::string_view lengths = "XYZUVWIJK";
    std::vector<AngleAsLength> found;
    const auto variables = kinds_of_variables(program);
    for (ItemId item = 0; item < program.items.size(); ++item) {
        const auto block = stored_block(program, item);
        if (!block || !is_plain_move(program, *block)) continue;
        for (const Word& word : block->words) {
            const auto* id = std::get_if<ExpressionId>(&word.value);
            if (id == nullptr || word.address.size() != 1 ||
                lengths.find(word.address) == std::string_view::npos)
                continue;
            Kind kind = kind_of(program, *id);
            if (const Load* load = variable_in(program, *id)) {
                const auto known = variables.find(load->variable);
                kind = known == variables.end() ? Kind::other : known->second;
            }
            if (kind != Kind::other) found.push_back({word.span, kind == Kind::angle});
        }
    }
    if (std::ranges::any_of(found, &AngleAsLength::is_angle) && may_be_polar(program))
        std::erase_if(found, [](const AngleAsLength& length) { return length.is_angle; });
    return found;
}

} // namespace maclint::rules
