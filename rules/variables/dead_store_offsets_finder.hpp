//! Numbers of the machine that are set twice in a row.
#pragma once

#include "analyzer/program/model.hpp"

#include <vector>

namespace maclint::rules {

/// Two assignments in blocks one after the other that set the same.
struct OffsetSetTwice {
    EffectId lost;
    EffectId next;
};

/// Of offsets and other numbers that keep what is stored, and whose second value does not read the first. In
/// text order.
[[nodiscard]] std::vector<OffsetSetTwice> find_offsets_set_twice(const Program& program);

} // namespace maclint::rules
