//! Words of lengths that get a sine, cosine or tangent.
#pragma once

#include "analyzer/program/model.hpp"

#include <vector>

namespace maclint::rules {

/// Words of moves whose whole value is the result of SIN, COS or TAN: `X-SIN[#1]`, with nothing that makes a
/// length of it. In the order of the text.
[[nodiscard]] std::vector<Span> find_ratios_as_lengths(const Program& program);

} // namespace maclint::rules
