//! The ways that tools take over a mill's table.
#pragma once

#include "analyzer/machine/states.hpp"

#include <array>
#include <cstddef>
#include <vector>

namespace maclint::machine {

/// A place above the table.
using Point = std::array<double, 2>;

/// A straight piece of a move, from one height to another.
struct Way {
    Point from, to;
    double z_from, z_to;
    bool cuts;
    double frame; ///< the work offset that its positions count from
    double tool;  ///< the block of the tool's change
    Span block;

    [[nodiscard]] double lower() const { return z_from < z_to ? z_from : z_to; }
    [[nodiscard]] double higher() const { return z_from < z_to ? z_to : z_from; }
};

/// From end to end of a straight line.
[[nodiscard]] double distance(const Point& a, const Point& b);
/// From the way, seen from above.
[[nodiscard]] double distance(const Point& point, const Way& way);
/// The point at this part of a line, 0 to 1.
[[nodiscard]] Point between(const Point& a, const Point& b, double part);

/// In the order of the text.
struct Ways {
    std::vector<Way> ways;
    bool in_inches = false;
};

/// Of a mill's program that is no longer than programs by hand are, and moves only where its text says it, in
/// the plane of X and Y; none of others.
[[nodiscard]] Ways ways_of(const Program& program, const States& states);

} // namespace maclint::machine
