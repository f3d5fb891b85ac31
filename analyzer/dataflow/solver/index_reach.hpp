//! Which variables a store through an index may mean.
#pragma once

#include "analyzer/program/model.hpp"
#include "analyzer/semantics/range.hpp"

namespace maclint::dataflow {

/// The numbers that an index may be.
struct IndexReach {
    semantics::Range numbers;
    bool locals = true; ///< those of local variables, too
};

/// `known` is the range of the index. Where that has no end on one side, the custom of the family's
/// programmers (IndexCustom) counts as well.
[[nodiscard]] IndexReach reach_of(const Program& program, FamilyId family, ExpressionId index,
                                  const semantics::Range& known);

} // namespace maclint::dataflow
