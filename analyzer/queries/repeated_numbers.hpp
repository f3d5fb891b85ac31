//! Block numbers that stand more than once where something looks for them.
#pragma once

#include "analyzer/program/numbered_blocks.hpp"
#include "analyzer/workspace/program_analysis.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace maclint::queries {

struct RepeatedNumber {
    std::int64_t number;
    std::vector<Span> blocks;  ///< the places of the number, at least two, in text order
    EffectId user;             ///< the first effect that leads to one of them
    std::optional<Span> taken; ///< the place that a jump with a plain number finds; nothing for other users
};

/// Numbers that words of the program name in other sections, then those that it jumps to. Numbers that
/// nothing names are left out.
[[nodiscard]] std::vector<RepeatedNumber> find_repeated_numbers(const ProgramAnalysis& analysis);

} // namespace maclint::queries
