//! Which numbers programs and blocks may have.
#pragma once

#include "analyzer/program/tables.hpp"

#include <cstdint>
#include <string_view>

namespace maclint {

struct NumberLimits {
    bool zero_is_program; ///< O0 is one
    std::int64_t last_program, last_block;
    std::string_view source;
};

/// Nothing where no number is known that the control refuses.
[[nodiscard]] const NumberLimits* number_limits(const ControlModel& control);

} // namespace maclint
