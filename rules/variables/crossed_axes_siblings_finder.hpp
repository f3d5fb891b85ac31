//! Statements that add to their own variable, and one like them that adds to another's.
#pragma once

#include "analyzer/program/model.hpp"

#include <string>
#include <vector>

namespace maclint::rules {

/// A statement that goes on from the variable of a sibling.
struct FromSibling {
    EffectId effect;
    ExpressionId operand; ///< what stands in the place of its own variable
    std::string own;      ///< "#5262"
    EffectId sibling;     ///< a statement that goes on from its own
    bool counts;          ///< both are counters: they are set back to the same number
};

/// Of `#5262=#5242+#102` where two others of the program add to their own number and no other one does
/// otherwise; of `#511=#510+1` beside `#510=#510+1` where both are set to the same number elsewhere and
/// nothing else sets #511; of `#[#11+2]=#[#10+1]+#26` where two others take the same step beyond #10 and #11.
/// In the order of the text.
[[nodiscard]] std::vector<FromSibling> find_statements_from_siblings(const Program& program);

} // namespace maclint::rules
