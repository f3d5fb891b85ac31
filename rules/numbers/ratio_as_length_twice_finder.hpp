//! Moves that take one and the same sine or cosine for two axes.
#pragma once

#include "analyzer/program/model.hpp"

#include <vector>

namespace maclint::rules {

/// Two words of a block.
struct SameRatioTwice {
    Span first, second; ///< X[#24+#4*COS[#14]], Y[#25+#4*COS[#14]]
    bool is_cosine;
};

/// Words for two axes, or for the centre of a circle along two, that hold one product each, with a length and
/// a sine or cosine that are the same in both, and no other function: nothing on a circle is at both, but
/// where it is halfway. In the order of the text.
[[nodiscard]] std::vector<SameRatioTwice> find_same_ratios(const Program& program);

} // namespace maclint::rules
