//! Numbers of system variables that go by axes: positions and offsets.
#pragma once

#include "analyzer/program/tables.hpp"

#include <cstdint>
#include <optional>
#include <string_view>

namespace maclint {

/// Numbers in a row, one for each axis.
struct AxisNumbers {
    std::int32_t first, last;
    /// How many a set of axes takes; the next set begins so many further on.
    std::int32_t of_a_set;
    /// Of work offsets: the code under which the first set counts; the next set has the next code.
    std::optional<double> first_code;
    std::string_view source;

    /// The axis, from 1 on.
    [[nodiscard]] std::int32_t axis(std::int32_t number) const { return (number - first) % of_a_set + 1; }
    /// The code under which an offset counts; only where there is a first one.
    [[nodiscard]] double code(std::int32_t number) const { return *first_code + (number - first) / of_a_set; }
};

/// The row of a number of the control; nullptr: it does not go by axes.
[[nodiscard]] const AxisNumbers* axis_numbers(const ControlModel& control, FamilyId family,
                                              std::int32_t number);

} // namespace maclint
