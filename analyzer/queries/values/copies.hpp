//! What a value is a copy of.
#pragma once

#include "analyzer/dataflow/facts/modal_read.hpp"
#include "analyzer/dataflow/facts/store.hpp"
#include "analyzer/workspace/program_analysis.hpp"

#include <optional>

namespace maclint {
struct VariableRange;
} // namespace maclint

namespace maclint::queries {

/// Whether both are results of one computation, and so equal whatever they are. Two that are equal by chance
/// are not.
[[nodiscard]] bool is_same_value(const dataflow::Value& a, const dataflow::Value& b);

/// The assignment that made the value the content of its variable; nullptr when several may have.
[[nodiscard]] const dataflow::Store* store_of(const ProgramAnalysis& analysis, const dataflow::Value& value);

/// That assignment. Where paths with different values meet, the only assignment to the variable that the
/// control can reach: on the other paths the program has stored nothing in it. Else nullptr.
[[nodiscard]] const dataflow::Store* only_store_of(const ProgramAnalysis& analysis, Variable variable,
                                                   const dataflow::Value& value);

/// Where a plain copy began: `#3=#4019` after `F#3`.
struct CopySource {
    ExpressionId expression;      ///< the modal or machine value that was read
    std::optional<GroupId> group; ///< of a modal value
    const VariableRange* range;   ///< of a machine value, or nullptr
};

/// What the expression, whose value is this, is a plain copy of; nothing for everything else.
[[nodiscard]] std::optional<CopySource> copy_source(const ProgramAnalysis& analysis, ExpressionId expression,
                                                    const dataflow::Value& value);

/// The read of a modal group whose result the assignment stores as it is: `#33=#4003`. Else nullptr.
[[nodiscard]] const dataflow::ModalRead* modal_read_of(const ProgramAnalysis& analysis,
                                                       const dataflow::Store& store);

/// The group whose state in force the assignment stores as it is; nothing for everything else.
[[nodiscard]] std::optional<GroupId> saved_group(const ProgramAnalysis& analysis,
                                                 const dataflow::Store& store);

/// Whether some assignment stores what is in force in the group, as it is.
[[nodiscard]] bool saves_group(const ProgramAnalysis& analysis, GroupId group);

/// Whether some assignment gives the variable this very value: `IF[#14GT#2]THEN#14=#2`.
[[nodiscard]] bool is_copied_into(const ProgramAnalysis& analysis, Variable variable,
                                  const dataflow::Value& value);

} // namespace maclint::queries
