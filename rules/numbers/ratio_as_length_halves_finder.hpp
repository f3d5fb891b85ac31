//! Sums of a place and half of another place of the same axis.
#pragma once

#include "analyzer/workspace/program_analysis.hpp"

#include <vector>

namespace maclint::rules {

/// `#10+#11/2` where #10 and #11 hold places: the middle of the two has brackets around their sum. Or
/// `[#10+#10]/2`, the middle of one.
struct HalfOfAPlace {
    EffectId effect; ///< the assignment, or the words
    ExpressionId sum;
    bool is_one_place; ///< `[#10+#10]/2`, of whatever #10 is
};

/// In the order of the text.
[[nodiscard]] std::vector<HalfOfAPlace> find_halves_of_places(const ProgramAnalysis& analysis);

} // namespace maclint::rules
