//! What closes a loop, and what decides whether it ends.
#pragma once

#include "analyzer/dataflow/facts/condition.hpp"
#include "analyzer/dataflow/loops.hpp"
#include "analyzer/source/exemption.hpp"
#include "analyzer/workspace/program_analysis.hpp"

#include <optional>
#include <vector>

namespace maclint::queries {

/// By which a loop is taken for one that somebody else ends.
namespace exemptions {
inline constexpr Exemption wait_for_others;
} // namespace exemptions

/// The WHILE or DO of the text that the loop is; nullptr for one that a jump closes.
[[nodiscard]] const flow::Region* region_of(const ProgramAnalysis& analysis, const dataflow::Loop& loop);

/// WHILE … DO, DO, or the jump that closes the loop; nothing when a program begins again at its end.
[[nodiscard]] std::optional<EffectId> repeated_by(const ProgramAnalysis& analysis,
                                                  const dataflow::Loop& loop);

/// The bytes of the same; of a program that begins again the text that runs last.
[[nodiscard]] Span span_of_repetition(const ProgramAnalysis& analysis, const dataflow::Loop& loop);

/// Whether jumps alone make the cycle, and none of its blocks leads out of it, not even by a condition that
/// is never true.
[[nodiscard]] bool is_endless_by_jumps(const dataflow::Loop& cycle);

/// Whether the cycle does what the return behind it would do: in a program that nobody calls and that gets no
/// arguments, M99 begins it again. The program moves, and only in the cycle, as where axes are run in.
[[nodiscard]] bool repeats_whole_program(const ProgramAnalysis& analysis, const dataflow::Loop& cycle);

/// Whether the loop lies in a cycle that jumps alone make endless.
[[nodiscard]] bool is_in_endless_jumps(const ProgramAnalysis& analysis, const dataflow::Loop& loop);

/// The variables that decide over the loop's exits, each once, where nothing of it can change in the loop;
/// none where constants decide or it has no exit. Nothing when something can change: an exit without a
/// condition, a value of the machine, a variable that the loop or, in one that only waits, somebody else may
/// set.
[[nodiscard]] std::optional<std::vector<Variable>> unchanging_deciders(const ProgramAnalysis& analysis,
                                                                       const dataflow::Loop& loop);

/// The first condition that would lead out of the loop, where none ever does though the loop changes what
/// they ask: #1=0 stands in the loop that counts #1. Nothing where a stop may end it, or somebody else for
/// whom it waits.
[[nodiscard]] std::optional<ExpressionId> condition_never_met(const ProgramAnalysis& analysis,
                                                              const dataflow::Loop& loop);

/// The condition of a WHILE that asks for less or more, which nothing in the loop changes, where only jumps
/// lead out and no path comes to the block behind it.
[[nodiscard]] std::optional<ExpressionId> idle_condition(const ProgramAnalysis& analysis,
                                                         const dataflow::Loop& loop);

/// Whether no path leads out of the loop.
[[nodiscard]] bool is_never_left(const ProgramAnalysis& analysis, const dataflow::Loop& loop);

/// Whether the condition asks for less or more, as one that counts does.
[[nodiscard]] bool asks_for_less_or_more(const Program& program, ExpressionId condition);

/// Whether it is the condition of a loop of the text, and not of an IF.
[[nodiscard]] bool is_loop_condition(const ProgramAnalysis& analysis, const dataflow::Condition& condition);

/// Whether the condition of a loop of the text holds no variable, and nothing else can end the loop: no jump
/// out of it, no stop.
[[nodiscard]] bool never_ends(const ProgramAnalysis& analysis, const dataflow::Condition& condition);

} // namespace maclint::queries
