//! Modal values that a program keeps in variables: where a word's value was copied from.
#pragma once

#include "analyzer/dataflow/facts/store.hpp"
#include "analyzer/workspace/program_analysis.hpp"

#include <optional>

namespace maclint::rules {

/// The assignment that gave the value its place; nothing when several may have.
[[nodiscard]] const dataflow::Store* store_of(const ProgramAnalysis& analysis, const dataflow::Value& value);

/// Where a plain copy began: `#3=#4019` after `F#3`.
struct CopySource {
    ExpressionId expression;      ///< the modal or machine value that was read
    std::optional<GroupId> group; ///< of a modal value
    const VariableRange* range;   ///< of a machine value, or nullptr
};

/// What the expression, whose value is this, is a plain copy of; nothing for everything else.
[[nodiscard]] std::optional<CopySource> copy_source(const ProgramAnalysis& analysis, ExpressionId expression,
                                                    const dataflow::Value& value);

} // namespace maclint::rules
