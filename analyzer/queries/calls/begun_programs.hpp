//! What single calls begin programs with, and where these then come by.
#pragma once

#include "analyzer/dataflow/domain/known_start.hpp"
#include "analyzer/dataflow/facts/call_begun.hpp"
#include "analyzer/dataflow/solver/analysis.hpp"
#include "analyzer/workspace/program_analysis.hpp"

#include <optional>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace maclint::queries {

[[nodiscard]] bool has_number(const dataflow::KnownVariable& known);
[[nodiscard]] bool has_numbers(const dataflow::KnownStart& start);

/// Whether the control has the number of an argument as it is written: a decimal point stands in it, or none
/// is missing.
[[nodiscard]] bool is_number_as_written(const ControlModel& control, std::string_view address, double value,
                                        bool decimal_point);

/// What a call begins a program with, its numbers as far as the control has the same: no calculation has
/// rounded them, and they are not passed without a decimal point, where a parameter says what they count in.
/// Nothing where no number is left.
[[nodiscard]] std::optional<dataflow::KnownStart> certain_numbers(const ProgramAnalysis& calling,
                                                                  const dataflow::CallBegun& begun);

/// A call that begins the program with numbers.
struct NumberedCall {
    const ProgramAnalysis* program; ///< in which it stands
    Span span;                      ///< empty: none is needed, the program's own text makes the numbers
    bool is_shown;                  ///< by a remark of the program itself
    dataflow::KnownStart start;
    std::optional<EffectId> effect; ///< of a call that stands in a block
};
/// The first of the program's known calls, each with other numbers; where it has none, those that its remarks
/// show. The facts CallBegun of its callers tell.
[[nodiscard]] std::vector<NumberedCall> calls_with_numbers(const ProgramAnalysis& analysis);

/// Whether the program, begun so, always comes by one of the nodes, unless it ends in an alarm before. Not
/// told of one that never ends otherwise.
[[nodiscard]] bool always_comes_by(const flow::Graph& graph, const dataflow::Analysis& begun,
                                   const std::vector<bool>& nodes);

/// The expressions that words of blocks are and whose numbers are known where the program is begun so. The
/// facts Read of that tell.
[[nodiscard]] std::unordered_map<ExpressionId, double> numbers_of_words(const Program& program,
                                                                        const dataflow::Analysis& begun);

} // namespace maclint::queries
