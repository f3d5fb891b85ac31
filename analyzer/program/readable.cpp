//! Counts the blocks of all programs of a file, those in plain runs included.
#include "analyzer/program/readable.hpp"

#include "analyzer/program/block_view.hpp"

#include <algorithm>
#include <variant>

namespace maclint {
namespace {

constexpr std::size_t enough_to_judge = 10;

std::size_t count_unreadable(const Program& program) {
    std::size_t count = 0;
    for_each_block_with_effects(program, [&](const BlockView& block) {
        const bool unreadable =
            std::ranges::any_of(program.effects_in(block.effects), [](const Effect& effect) {
                return std::holds_alternative<UnreadableBlock>(effect.what);
            });
        count += unreadable ? 1 : 0;
    });
    return count;
}

} // namespace

bool Readable::is_doubtful() const { return unreadable >= enough_to_judge && unreadable * 4 > blocks; }

Readable count_readable(const ProgramFile& file) {
    Readable count;
    for (const Program& program : file.programs) {
        count.blocks += count_blocks(program);
        count.unreadable += count_unreadable(program);
    }
    return count;
}

} // namespace maclint
