//! Contours on the face, the rear and the lateral surface, for the C and the Y axis, as far as the numbers
//! stand in the text.
#pragma once

#include "analyzer/queries/contours/turning_outline.hpp"

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace maclint::queries {

/// From a start point to the next one, or to another code. The two axes of its surface stand in `x` and `z`.
struct SurfaceContour {
    const Section* section = nullptr;
    std::string_view name = {}; ///< of the level G308 that holds it alone; empty: none
    std::optional<OutlinePoint> start;
    std::vector<OutlineElement> elements;
    std::vector<std::int64_t> numbers; ///< of its blocks
    bool is_whole = true;              ///< no other block may add to it
};

[[nodiscard]] std::vector<SurfaceContour> surface_contours(const Program& program);

} // namespace maclint::queries
