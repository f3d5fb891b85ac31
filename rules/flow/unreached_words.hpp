//! Blocks that no path reaches, in words.
#pragma once

#include "analyzer/queries/paths/unreached_regions.hpp"
#include "analyzer/source/exemption.hpp"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace maclint::rules {

/// By which unreached blocks are let pass.
namespace exemptions {
inline constexpr Exemption no_alarm_is_raised;
inline constexpr Exemption leads_to_an_end;
inline constexpr Exemption switches_behind_end;
inline constexpr Exemption block_without_moves;
} // namespace exemptions

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
