//! Whether the circle that a block asks for can be.
#pragma once

#include "analyzer/machine/step.hpp"

#include <cstdint>
#include <optional>
#include <string>

namespace maclint::machine {

/// What is wrong with a circle.
enum class ArcFault : std::uint8_t {
    none,
    radii,           ///< its start and its end lie at different distances from the centre
    chord,           ///< its ends are further apart than it is wide
    zero_radius,     ///< R0
    centre_at_start, ///< I0 J0
    nothing_moves,   ///< it ends where it begins, and its radius says no more
    no_centre,       ///< neither a centre nor a radius, where nothing else can say where it is
    other_plane,     ///< a centre letter of an axis outside its plane
};

/// A circle by its centre or its radius.
struct Arc {
    ArcFault fault = ArcFault::none;
    /// Of `radii`: the distances from the centre. Of `chord`: between the ends, and the most by the radius.
    double first = 0, second = 0;
    char letter = 0;             ///< of the word that is at fault: 'R', 'K'
    bool leaves_plane = false;   ///< its end names the axis outside its plane
    bool plane_of_start = false; ///< nobody has said the plane: it is the one in which such machines begin
    std::string letters = {};    ///< of a centre in its plane: "I and J"; of a radius, where nothing is given
};

/// The circle of a block; nothing where it asks for none, or nobody can say what circle that is.
[[nodiscard]] std::optional<Arc> arc_of(const Step& step, const Program& program);

} // namespace maclint::machine
