//! Counts the blocks of all programs of a file, those in plain runs included.
#include "analyzer/program/readable.hpp"

#include <algorithm>
#include <variant>

namespace maclint {
namespace {

constexpr std::size_t enough_to_judge = 10;

bool is_unreadable(const Program& program, const Block& block) {
    const auto effects = std::span(program.effects).subspan(block.effects.first, block.effects.count);
    return std::ranges::any_of(
        effects, [](const Effect& effect) { return std::holds_alternative<UnreadableBlock>(effect.what); });
}

} // namespace

bool Readable::is_doubtful() const { return unreadable >= enough_to_judge && unreadable * 4 > blocks; }

Readable count_readable(const ProgramFile& file) {
    Readable count;
    for (const Program& program : file.programs) {
        for (const Item& item : program.items) {
            if (const auto* run = std::get_if<PlainRun>(&item)) {
                count.blocks += run->blocks;
                continue;
            }
            ++count.blocks;
            if (is_unreadable(program, std::get<Block>(item))) ++count.unreadable;
        }
    }
    return count;
}

} // namespace maclint
