//! Blocks that no path reaches, in words.
#pragma once

#include "analyzer/queries/unreached_regions.hpp"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace maclint::rules {

/// What is said of a region, and of the blocks at `place`.
struct UnreachedWords {
    std::string_view message;
    Span place;
    std::vector<std::string> words;
    bool is_sure;
    std::span<const EffectId> others = {}; ///< alarms that are not raised, either
};

/// Nothing where the blocks may stand there on purpose, alarms where `another_is_raised` is false.
[[nodiscard]] std::optional<UnreachedWords>
words_for(const ProgramAnalysis& analysis, const queries::UnreachedRegion& region, bool another_is_raised);

} // namespace maclint::rules
