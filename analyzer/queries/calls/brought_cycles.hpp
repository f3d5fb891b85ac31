//! Calls of the programs that a control brings.
#pragma once

#include "analyzer/program/language_words.hpp"
#include "analyzer/workspace/program_analysis.hpp"

#include <optional>
#include <string_view>

namespace maclint::queries {

/// The cycle of the control that the effect calls; nullptr: it calls none, or a program of the shop that has
/// its name.
[[nodiscard]] const BroughtCycle* cycle_called(const ProgramAnalysis& analysis, EffectId effect);
/// Whether the program calls others than the cycles of its control: what it does not do itself they may.
[[nodiscard]] bool calls_programs(const Program& program);
/// The number that stands there as the cycle's parameter; nothing where it is left out or calculated, and
/// where the call has more places than the list: in a newer form of the cycle the same place may be a
/// diameter.
[[nodiscard]] std::optional<double> number_passed(const Program& program, const Call& call,
                                                  const BroughtCycle& cycle, std::string_view parameter);
/// Whether the call has arguments and leaves that one out; false where number_passed() knows no place for it.
[[nodiscard]] bool is_left_out(const Program& program, const Call& call, const BroughtCycle& cycle,
                               std::string_view parameter);

} // namespace maclint::queries
