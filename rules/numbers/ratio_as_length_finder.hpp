//! Words of lengths that get a sine, cosine or tangent, or an angle.
#pragma once

#include "analyzer/program/model.hpp"

#include <vector>

namespace maclint::rules {

struct AngleAsLength {
    Span word;
    bool is_angle; ///< else the ratio of two sides
};

/// Words of moves whose whole value is the result of SIN, COS or TAN: `X-SIN[#1]`, with nothing that makes a
/// length of it, or a variable that nothing else is stored in than this, or than the result of ASIN, ACOS or
/// ATAN. Under polar coordinates angles are positions: no angles of a program that may switch them on. In the
/// order of the text.
[[nodiscard]] std::vector<AngleAsLength> find_angles_as_lengths(const Program& program);

} // namespace maclint::rules
