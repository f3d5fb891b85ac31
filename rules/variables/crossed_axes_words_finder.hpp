//! Positions that are kept for one axis and move another.
#pragma once

#include "analyzer/program/model.hpp"

#include <vector>

namespace maclint::rules {

/// A variable that keeps where one axis is, and in words only moves another one to it.
struct PlaceForAnotherAxis {
    EffectId store;    ///< #11=#5041
    Variable variable; ///< #11
    Span word;         ///< Y[#11-#8]
    Variable twin;     ///< keeps the same, and moves the axis that it is a place of
    Variable meant;    ///< the position of the axis that is moved: #5042
    char axis;         ///< of which the position is
};

/// Where another variable keeps the same position and moves its own axis by it, and each of the two moves no
/// other axis: `#10=#5041`, `#11=#5041`, `X[#10+#8]`, `Y[#11+#8]`. A variable may get other values as well.
/// In the order of the text.
[[nodiscard]] std::vector<PlaceForAnotherAxis> find_places_for_other_axes(const Program& program);

} // namespace maclint::rules
