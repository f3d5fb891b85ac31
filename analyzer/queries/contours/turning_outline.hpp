//! Turning contours, and moves in the same plane, as far as the numbers stand in the text.
#pragma once

#include "analyzer/program/model.hpp"

#include <optional>
#include <vector>

namespace maclint::queries {

/// In mm or inches, as the program has them; `x` is a radius.
struct OutlinePoint {
    double x, z;
};

/// A straight line or an arc.
struct OutlineElement {
    Span block = {};
    Span code = {}; ///< of its G word; empty where the block goes on with the code before
    bool is_arc = false;
    std::optional<OutlinePoint> from, to; ///< nothing: nobody can say
    std::optional<OutlinePoint> centre;
    std::optional<double> radius;
    std::optional<double> corner; ///< to the next element: a chamfer below 0, a rounding above
    Span corner_span = {};
};

/// Elements of a contour in a row, each from where the one before ends; of moves the arcs.
struct Outline {
    const Section* section = nullptr;
    bool describes = false; ///< a contour, and not moves of the tool
    std::vector<OutlineElement> elements;
    std::vector<Offset> gaps = {}; ///< blocks, in text order, that may describe what nobody can say

    /// The element that a block lies on, which stands before it, and the next one behind it; nullptr: there
    /// is none, or a gap lies between.
    [[nodiscard]] const OutlineElement* before(Offset block) const;
    [[nodiscard]] const OutlineElement* behind(Offset block) const;

  private:
    [[nodiscard]] bool has_gap(Offset begin, Offset end) const;
};

/// Those of a program whose control turns: one for each contour.
[[nodiscard]] std::vector<Outline> turning_contours(const Program& program);
/// Those contours, and the moves of each section that runs.
[[nodiscard]] std::vector<Outline> turning_contours_and_moves(const Program& program);

/// A bar or a tube that a blank is, by its one block; in mm or inches.
struct Bar {
    double diameter;
    double left, right; ///< ends along Z
    double bore = 0;    ///< diameter inside; 0: none
};
/// Nothing where the section says it otherwise.
[[nodiscard]] std::optional<Bar> bar_of(const Program& program, const Section& section);

[[nodiscard]] double distance(const OutlinePoint& a, const OutlinePoint& b);

} // namespace maclint::queries
