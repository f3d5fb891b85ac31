//! The geometry of circles: from the way to their end, and their centre or radius.
#include "analyzer/machine/arc.hpp"

#include "analyzer/program/model.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace maclint::machine {
namespace {

using Pair = std::array<double, 2>;

/// Words that say more of a move than a circle of the plane: rotary axes, spirals and turns.
constexpr std::string_view of_other_curves = "ABCELPQ";
/// Modes whose positions are no lengths along two straight axes of one scale.
constexpr std::array bent = {ModalRole::polar_coordinates, ModalRole::polar_interpolation,
                             ModalRole::scaling};
constexpr std::size_t x_axis = 0, y_axis = 1, z_axis = 2;

double length(const Pair& way) { return std::hypot(way[0], way[1]); }

/// Reads the words of a circle.
class Reader {
  public:
    Reader(const Step& step, const Program& program)
        : step_(step)
        , program_(program)
        , control_(*program.control)
        , machine_(*control_.machine_words) {}

    [[nodiscard]] std::optional<Arc> read() const;

  private:
    [[nodiscard]] bool is_circle() const;
    [[nodiscard]] bool lacks_centre() const;
    [[nodiscard]] bool has_centre_only_outside(std::size_t axis) const;
    [[nodiscard]] bool has_end(std::size_t axis) const {
        return has(machine_.axes[axis]) || has(machine_.increments[axis]);
    }
    [[nodiscard]] bool has(char letter) const { return letter != 0 && step_.words.has(letter); }
    [[nodiscard]] bool has_centre() const {
        return std::ranges::any_of(machine_.centres, [&](char letter) { return has(letter); });
    }
    [[nodiscard]] bool can_be_read(char letter) const;
    [[nodiscard]] double value(char letter) const;
    [[nodiscard]] double from_start(std::size_t axis) const;
    [[nodiscard]] bool has_absolute_centre() const {
        return std::ranges::any_of(machine_.centres,
                                   [&](char letter) { return step_.words.absolute(letter).has_value(); });
    }
    [[nodiscard]] std::optional<std::size_t> outside_axis() const;
    [[nodiscard]] std::optional<std::size_t> outside_axis_by_letters() const;
    [[nodiscard]] std::optional<double> way(std::size_t axis) const;
    [[nodiscard]] Arc by_radius(const Pair& way) const;
    [[nodiscard]] Arc by_centre(const Pair& way, std::size_t outside) const;
    [[nodiscard]] bool fits_otherwise(const Pair& way, const Pair& centre) const;
    [[nodiscard]] bool takes_place_in_plane(std::size_t outside) const;
    [[nodiscard]] double tolerance() const;
    [[nodiscard]] Pair in_plane(const std::array<double, 3>& of_axes) const;

    const Step& step_;
    const Program& program_;
    const ControlModel& control_;
    const MachineWords& machine_;
    std::array<std::size_t, 2> plane_ = {x_axis, y_axis};

  public:
    /// Whether the place of the start is known, and no length may be a diameter.
    [[nodiscard]] bool knows_centre(std::size_t outside) const {
        const Pair start = in_plane(step_.before.position);
        return !std::isnan(start[0]) && !std::isnan(start[1]) &&
               !(machine_.diameter_by_code && outside == y_axis);
    }
    void choose_plane(std::size_t outside) {
        plane_ = {outside == x_axis ? y_axis : x_axis, outside == z_axis ? y_axis : z_axis};
    }
};

bool Reader::is_circle() const {
    if (!moves_on_circle(step_, control_)) return false;
    if (std::ranges::any_of(of_other_curves, [&](char letter) { return has(letter); })) return false;
    return std::ranges::none_of(bent, [&](ModalRole role) { return may_be_on(step_.after, control_, role); });
}

/// A number without a point may mean steps of a thousandth.
bool Reader::can_be_read(char letter) const {
    if (!has(letter) || step_.words.absolute(letter)) return true;
    const auto number = step_.words.number(letter);
    return number && number->is_length();
}

double Reader::value(char letter) const {
    const auto number = letter == 0 ? std::nullopt : step_.words.number(letter);
    return number ? number->value : 0;
}

/// The centre's place along the axis.
double Reader::from_start(std::size_t axis) const {
    const char letter = machine_.centres[axis];
    const auto absolute = step_.words.absolute(letter);
    return absolute ? *absolute - step_.before.position[axis] : value(letter);
}

/// The axis that stands on the plane.
std::optional<std::size_t> Reader::outside_axis() const {
    const auto group = control_.group_with(ModalRole::plane);
    const Known& plane = step_.after.of(ModalRole::plane);
    if (!group || plane.is_callers()) return outside_axis_by_letters();
    if (!plane.is_known()) return std::nullopt;
    const auto& planes = control_.groups[*group].members; // X Y, Z X, Y Z
    const auto found = std::ranges::find(planes, plane.value, &ModalMember::number);
    const auto index = static_cast<std::size_t>(found - planes.begin());
    return index > z_axis ? std::nullopt : std::optional(z_axis - index);
}

/// Where the program has not said it: the plane in which the machine begins, if no letter speaks against it.
std::optional<std::size_t> Reader::outside_axis_by_letters() const {
    if (machine_.x_is_diameter) {
        const bool in_plane_of_lathes = !has_end(y_axis) && (has_end(x_axis) || has_end(z_axis));
        const bool in_other = has_end(y_axis) || has(machine_.centres[y_axis]);
        return in_plane_of_lathes || !in_other ? std::optional(y_axis) : std::nullopt;
    }
    if (!has_end(z_axis)) return has_end(x_axis) || has_end(y_axis) ? std::optional(z_axis) : std::nullopt;
    if (has_end(x_axis) && has_end(y_axis) && !has(machine_.centres[z_axis])) return z_axis;
    // What moves in Y is no lathe whose control is set up as a mill.
    return has(machine_.centres[z_axis]) && !std::isnan(step_.before.position[y_axis]) ? std::optional(z_axis)
                                                                                       : std::nullopt;
}

/// From start to end along an axis, as it is programmed.
std::optional<double> Reader::way(std::size_t axis) const {
    const char increment = machine_.increments[axis], absolute = machine_.axes[axis];
    if (has(increment)) return can_be_read(increment) ? std::optional(value(increment)) : std::nullopt;
    if (!has(absolute)) return 0;
    if (!can_be_read(absolute)) return std::nullopt;
    const Known& distance = step_.after.of(ModalRole::distance);
    if (control_.group_with(ModalRole::distance) && distance.is_known() && !distance.is(machine_.absolute))
        return value(absolute);
    const double between = step_.after.position[axis] - step_.before.position[axis];
    return std::isnan(between) ? std::nullopt : std::optional(between);
}

/// How far a circle may be off for what is lost in the last digit, in the program's unit.
double Reader::tolerance() const {
    std::size_t decimals = 0;
    for (const char letter : {machine_.axes[0], machine_.axes[1], machine_.axes[2], machine_.centres[0],
                              machine_.centres[1], machine_.centres[2], machine_.radius}) {
        if (!has(letter)) continue;
        const Span span = step_.words.word(letter)->span;
        const std::string_view word = program_.text.substr(span.begin, span.length());
        const std::size_t point = word.find('.');
        if (point == std::string_view::npos) continue;
        const std::size_t end = word.find_first_not_of("0123456789", point + 1);
        decimals = std::max(decimals, std::min(end, word.size()) - point - 1);
    }
    constexpr double digits = 1.5;
    const double rounding = decimals == 0 ? 0 : digits * std::pow(10, -static_cast<double>(decimals));
    const bool is_inch = step_.after.of(ModalRole::units).is(machine_.inch);
    return std::max(machine_.circle_tolerance / (is_inch ? millimetres_of_inch : 1), rounding);
}

Pair Reader::in_plane(const std::array<double, 3>& of_axes) const {
    Pair pair = {of_axes[plane_[0]], of_axes[plane_[1]]};
    if (machine_.x_is_diameter && plane_[0] == x_axis) pair[0] /= 2;
    return pair;
}

Arc Reader::by_radius(const Pair& way) const {
    const double radius = std::abs(value(machine_.radius));
    Arc arc{.first = length(way), .second = 2 * radius, .letter = machine_.radius};
    if (radius == 0)
        arc.fault = ArcFault::zero_radius;
    else if (arc.first < tolerance() / 100)
        arc.fault = ArcFault::nothing_moves;
    else if (arc.first - arc.second > tolerance())
        arc.fault = ArcFault::chord;
    return arc;
}

/// Whether the two ends lie on one circle when the centre is read in another way, as some controls do.
bool Reader::fits_otherwise(const Pair& way, const Pair& centre) const {
    const auto differ = [](const Pair& from_start, const Pair& to_end) {
        return std::abs(length(from_start) - length({to_end[0] - from_start[0], to_end[1] - from_start[1]}));
    };
    const Pair start = in_plane(step_.before.position);
    const Pair absolute = {centre[0] - start[0], centre[1] - start[1]};
    if (differ(absolute, way) <= tolerance()) return true;
    if (!machine_.x_is_diameter || plane_[0] != x_axis) return false;
    return differ(centre, {2 * way[0], way[1]}) <= tolerance();
}

/// Whether both letters of the axis outside the plane stand where both of one in it are missing: Y and J0 for
/// Z and K0.
bool Reader::takes_place_in_plane(std::size_t outside) const {
    return has_end(outside) && std::ranges::any_of(plane_, [&](std::size_t axis) {
               return !has_end(axis) && !has(machine_.centres[axis]);
           });
}

Arc Reader::by_centre(const Pair& way, std::size_t outside) const {
    const Pair centre = {from_start(plane_[0]), from_start(plane_[1])};
    Arc arc{.first = length(centre), .second = length({way[0] - centre[0], way[1] - centre[1]})};
    const bool fits = std::abs(arc.first - arc.second) <= tolerance();
    if (const char other = machine_.centres[outside]; value(other) != 0) {
        // Beside a centre in the plane some give the pitch of a helix there.
        if (fits && arc.first > 0 && this->way(outside) != 0) return arc;
        arc.fault = ArcFault::other_plane;
        arc.letter = other;
        arc.leaves_plane = has_end(outside);
    } else if (has(other) && takes_place_in_plane(outside)) {
        arc.fault = ArcFault::other_plane;
        arc.letter = other;
        arc.leaves_plane = has_end(outside);
    } else if (arc.first == 0) {
        arc.fault = ArcFault::centre_at_start;
    } else if (!fits && (has_absolute_centre() || !fits_otherwise(way, centre))) {
        arc.fault = ArcFault::radii;
    }
    return arc;
}

/// Whether the block says that it is an arc and where it ends, but nothing of its centre. Other controls go
/// straight then.
bool Reader::lacks_centre() const {
    constexpr double clockwise = 2, counterclockwise = 3;
    const bool says_it = step_.words.has_g(clockwise) || step_.words.has_g(counterclockwise);
    return !machine_.radius_address.empty() && says_it && !has(machine_.radius) && !has_centre() &&
           !step_.words.has_other_target() && (has_end(x_axis) || has_end(y_axis) || has_end(z_axis));
}

/// `G17 G3 K-#31`, `G17 G3 J0 K-#31`: whatever the value is, or none, the circle has no centre.
bool Reader::has_centre_only_outside(std::size_t axis) const {
    const char outside = machine_.centres[axis];
    const bool is_alone = std::ranges::none_of(machine_.centres, [&](char letter) {
        return letter != outside && has(letter) && (!can_be_read(letter) || value(letter) != 0);
    });
    return is_alone && has(outside) && !can_be_read(outside) && !step_.words.number(outside);
}

std::optional<Arc> Reader::read() const {
    if (!is_circle()) return std::nullopt;
    if (lacks_centre())
        return Arc{.fault = ArcFault::no_centre, .letters = std::string(machine_.radius_address)};
    if (has(machine_.radius) == has_centre()) return std::nullopt;
    const std::optional<std::size_t> outside = outside_axis();
    if (!outside) return std::nullopt;
    Reader chosen = *this;
    chosen.choose_plane(*outside);
    const std::string letters =
        std::string(1, machine_.centres[chosen.plane_[0]]) + " and " + machine_.centres[chosen.plane_[1]];
    const bool plane_of_start = step_.after.of(ModalRole::plane).is_callers();
    if (has_centre_only_outside(*outside))
        return Arc{.fault = ArcFault::other_plane,
                   .letter = machine_.centres[*outside],
                   .leaves_plane = has_end(*outside),
                   .plane_of_start = plane_of_start,
                   .letters = letters};
    for (const char letter : machine_.centres)
        if (!can_be_read(letter)) return std::nullopt;
    if (!can_be_read(machine_.radius)) return std::nullopt;
    if (has_absolute_centre() && !chosen.knows_centre(*outside)) return std::nullopt;
    std::array<double, 3> ways = {};
    for (const std::size_t axis : chosen.plane_) {
        const std::optional<double> along = way(axis);
        if (!along) return std::nullopt;
        ways[axis] = *along;
    }
    const Pair plane_way = chosen.in_plane(ways);
    const auto arc_along = [&](const Pair& along) {
        return has_centre() ? chosen.by_centre(along, *outside) : chosen.by_radius(along);
    };
    Arc arc = arc_along(plane_way);
    // Lengths that may be diameters: only what is no circle either way is told. A letter of another plane, or
    // a circle without a way, is wrong whatever they are.
    const bool may_be_diameter = machine_.diameter_by_code && *outside == y_axis &&
                                 arc.fault != ArcFault::nothing_moves &&
                                 (arc.fault != ArcFault::other_plane || has_end(*outside));
    if (may_be_diameter) {
        const Arc halved = arc_along({plane_way[0] / 2, plane_way[1]});
        if (arc.fault == ArcFault::none || halved.fault == ArcFault::none) return std::nullopt;
        arc = halved;
    }
    arc.letters = letters;
    arc.plane_of_start = plane_of_start;
    return arc;
}

} // namespace

std::optional<Arc> arc_of(const Step& step, const Program& program) {
    if (step.move != Move::feed) return std::nullopt;
    return Reader(step, program).read();
}

} // namespace maclint::machine
