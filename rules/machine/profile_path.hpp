//! The points of a profile that a roughing cycle reads, and what they say against it.
#pragma once

#include "analyzer/source/span.hpp"
#include "rules/machine_check.hpp"

#include <optional>
#include <vector>

namespace maclint {

/// What a roughing cycle is to turn away, in the order of its profile.
struct ProfilePath {
    /// NaN: nobody can say.
    struct Point {
        double x, z;
        Span block;
    };
    struct Range {
        double least, greatest;
    };
    double start_x, start_z;
    std::vector<Point> points;  ///< without a last block that only takes the tool away
    bool begins_along_one_axis; ///< then the control takes no pockets

    /// The least and the greatest; nothing where a point is not known, or all are the same.
    [[nodiscard]] std::optional<Range> xs() const { return range_of(&Point::x); }
    [[nodiscard]] std::optional<Range> zs() const { return range_of(&Point::z); }
    /// The first block that goes back on the way of the others by more than that.
    [[nodiscard]] const Point* first_back(double Point::*axis, double tolerance) const;

  private:
    [[nodiscard]] std::optional<Range> range_of(double Point::*axis) const;
};

/// The path of a cycle with P and Q; nothing where a block is missing, or stands twice, behind the other one
/// or behind the program's end: other rules tell that.
[[nodiscard]] std::optional<ProfilePath> profile_path(const MachineStep& at);

} // namespace maclint
