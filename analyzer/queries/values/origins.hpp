//! Where in a program the origin of a value or of a modal state stands.
#pragma once

#include "analyzer/dataflow/domain/value.hpp"
#include "analyzer/workspace/program_analysis.hpp"

#include <optional>

namespace maclint::queries {

/// The effect that the origin is; nothing for a plain block, an expression and the program's start.
[[nodiscard]] std::optional<EffectId> effect_of_origin(const ProgramAnalysis& analysis,
                                                       dataflow::OriginId origin);

/// The variable whose value at the program's start is meant; nothing for other origins.
[[nodiscard]] std::optional<Variable> variable_of_origin(const ProgramAnalysis& analysis,
                                                         dataflow::OriginId origin);

/// The node in which something came about; the program's first for what was so at its start.
[[nodiscard]] flow::NodeId node_of_origin(const ProgramAnalysis& analysis, dataflow::OriginId origin);

/// The bytes that made it: of a run of plain blocks the last block that sets the group. For what was so at
/// the program's start its name, or its first block where it has none.
[[nodiscard]] Span span_of_origin(const ProgramAnalysis& analysis, dataflow::OriginId origin);

/// Whether a run of plain blocks set it, whose words are not kept.
[[nodiscard]] bool is_plain_origin(const ProgramAnalysis& analysis, dataflow::OriginId origin);

/// Whether the program called at an effect left it so.
[[nodiscard]] bool is_made_by_call(const ProgramAnalysis& analysis, dataflow::OriginId origin);

} // namespace maclint::queries
