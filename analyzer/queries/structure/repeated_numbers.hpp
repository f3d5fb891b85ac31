//! Block numbers that stand more than once where something looks for them.
#pragma once

#include "analyzer/program/numbered_blocks.hpp"
#include "analyzer/source/exemption.hpp"
#include "analyzer/workspace/program_analysis.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace maclint::queries {

/// By which a number may stand twice.
namespace exemptions {
inline constexpr Exemption computed_jump_beside_each;
} // namespace exemptions

/// What becomes of a number that stands more than once.
enum class Doubling : std::uint8_t {
    harmless, ///< each jump takes the next block that bears it, as when blocks were copied with their jumps
    passed_over,   ///< a jump back takes the first of the program, not the one that stands before it
    unreached,     ///< the jumps take another block, and nothing leads to this one
    in_other_part, ///< a jump finds the block of another part of the program, behind an end or in a loop, not
                   ///< the one in its own part, which stands before it
    referenced,    ///< words of other sections name it, which find the one or the other
};

struct RepeatedNumber {
    std::int64_t number;
    std::vector<Span> blocks;  ///< the places of the number, at least two, in text order
    EffectId user;             ///< the effect that leads to the wrong one, else the first that leads to one
    std::optional<Span> taken; ///< the place that a jump with a plain number finds; nothing for other users
    Doubling doubling;
    std::optional<Span> missed; ///< the place passed over or unreached
};

/// Numbers that words of the program name in other sections, then those that it jumps to. Numbers that
/// nothing names are left out, and those of which each block has a computed jump of its own.
[[nodiscard]] std::vector<RepeatedNumber> find_repeated_numbers(const ProgramAnalysis& analysis);

} // namespace maclint::queries
