//! Looks at the words of blocks that move.
#include "rules/numbers/ratio_as_length_finder.hpp"

#include "analyzer/program/block_view.hpp"

#include <algorithm>
#include <span>
#include <string_view>
#include <variant>

namespace maclint::rules {
namespace {

/// Whether the expression compares the sides of a triangle, signs and brackets aside.
bool is_ratio(const Program& program, ExpressionId id) {
    const auto* apply = std::get_if<Apply>(&program.expressions[id].node);
    if (apply == nullptr) return false;
    if (apply->operation == Operation::negate) return is_ratio(program, program.operands_of(*apply).front());
    return apply->operation == Operation::sine || apply->operation == Operation::cosine ||
           apply->operation == Operation::tangent;
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

std::vector<Span> find_ratios_as_lengths(const Program& program) {
    constexpr std::string_view lengths = "XYZUVWIJK";
    std::vector<Span> found;
    for (ItemId item = 0; item < program.items.size(); ++item) {
        const auto block = stored_block(program, item);
        if (!block || !is_plain_move(program, *block)) continue;
        for (const Word& word : block->words) {
            const auto* id = std::get_if<ExpressionId>(&word.value);
            if (id == nullptr || word.address.size() != 1 ||
                lengths.find(word.address) == std::string_view::npos)
                continue;
            if (is_ratio(program, *id)) found.push_back(word.span);
        }
    }
    return found;
}

} // namespace maclint::rules
