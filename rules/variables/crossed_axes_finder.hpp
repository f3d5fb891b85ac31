//! Statements in a row that do the same for one axis after the other.
#pragma once

#include "analyzer/program/model.hpp"

#include <vector>

namespace maclint::rules {

/// An assignment that takes the variable of its sibling where the sibling takes its own.
struct CrossedStatements {
    EffectId effect;
    EffectId sibling;
    ExpressionId operand;  ///< the variable that stands in the wrong statement
    Variable meant;        ///< what the sibling lets expect there: what the assignment sets, or its axis
    Variable siblings_own; ///< what the sibling takes there
};

/// Pairs of assignments, one after the other, that only differ in numbers one apart: what they set, and what
/// they take, the places of two axes among it, or what they set is the letter of an axis. In one place the
/// first takes what it sets itself, and so does the second, or the other way round. A second pair of that
/// kind in the two may be an exchange on purpose. Or they set offsets of two axes, or take places of them,
/// and in one place both take the place of one axis: `#5221=#5221+#5061`, `#5222=#5222+#5061`.
[[nodiscard]] std::vector<CrossedStatements> find_crossed_statements(const Program& program);

} // namespace maclint::rules
