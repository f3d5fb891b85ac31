//! Gathers the pieces of moves.
#include "analyzer/machine/ways.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace maclint::machine {

double distance(const Point& a, const Point& b) { return std::hypot(a[0] - b[0], a[1] - b[1]); }

Point between(const Point& a, const Point& b, double part) {
    return {a[0] + (b[0] - a[0]) * part, a[1] + (b[1] - a[1]) * part};
}

double distance(const Point& point, const Way& way) {
    const double dx = way.to[0] - way.from[0], dy = way.to[1] - way.from[1];
    const double square = dx * dx + dy * dy;
    const double part =
        square == 0
            ? 0
            : std::clamp(((point[0] - way.from[0]) * dx + (point[1] - way.from[1]) * dy) / square, 0.0, 1.0);
    return distance(point, between(way.from, way.to, part));
}

namespace {

constexpr std::size_t x_axis = 0, y_axis = 1, z_axis = 2;
/// More moves come from CAM systems, which know what is cut.
constexpr std::size_t most_ways = 4000;
/// The ways of a program in the order of the text, as far as its positions are known.
class Gatherer {
  public:
    explicit Gatherer(const Program& program)
        : control_(*program.control)
        , machine_(*control_.machine_words) {}

    void see(const Step& step);
    [[nodiscard]] bool is_usable() const { return is_usable_; }
    [[nodiscard]] bool is_inch() const { return is_inch_; }
    [[nodiscard]] const std::vector<Way>& ways() const { return ways_; }

  private:
    void add(const Step& step, const Point& from, const Point& to, double z_from, double z_to);
    void add_arc(const Step& step, const Point& from, const Point& to, double z_from, double z_to);
    [[nodiscard]] std::optional<Point> centre_of(const Step& step, const Point& from, const Point& to,
                                                 bool clockwise) const;

    const ControlModel& control_;
    const MachineWords& machine_;
    std::vector<Way> ways_;
    bool is_usable_ = true, is_inch_ = true;
};

void Gatherer::add(const Step& step, const Point& from, const Point& to, double z_from, double z_to) {
    const Known& frame = step.after.of(ModalRole::work_offset);
    ways_.push_back({.from = from,
                     .to = to,
                     .z_from = z_from,
                     .z_to = z_to,
                     .cuts = step.move != Move::rapid,
                     .frame = frame.is_known() ? frame.value : 0,
                     .tool = static_cast<double>(step.after.changed.block),
                     .block = step.block.span});
}

std::optional<Point> Gatherer::centre_of(const Step& step, const Point& from, const Point& to,
                                         bool clockwise) const {
    if (!step.words.has(machine_.radius)) {
        const auto i = step.words.number(machine_.centres[x_axis]),
                   j = step.words.number(machine_.centres[y_axis]);
        if (!i && !j) return std::nullopt;
        return Point{from[0] + (i ? i->value : 0), from[1] + (j ? j->value : 0)};
    }
    const auto radius = step.words.number(machine_.radius);
    const double chord = distance(from, to);
    if (!radius || chord == 0) return std::nullopt;
    const double height = std::sqrt(std::max(0.0, radius->value * radius->value - chord * chord / 4));
    const double side = (clockwise ? 1 : -1) * (radius->value < 0 ? -1 : 1) * height / chord;
    const Point middle = between(from, to, 0.5);
    return Point{middle[0] + side * (to[1] - from[1]), middle[1] - side * (to[0] - from[0])};
}

void Gatherer::add_arc(const Step& step, const Point& from, const Point& to, double z_from, double z_to) {
    constexpr int pieces = 16;
    const bool clockwise = step.after.of(ModalRole::motion).is(2);
    const std::optional<Point> centre = centre_of(step, from, to, clockwise);
    if (!centre) return add(step, from, to, z_from, z_to);
    const double begin = std::atan2(from[1] - (*centre)[1], from[0] - (*centre)[0]);
    double angle = std::atan2(to[1] - (*centre)[1], to[0] - (*centre)[0]) - begin;
    constexpr double full = 2 * std::numbers::pi, nearly_nothing = 1e-9;
    if (clockwise && angle > -nearly_nothing) angle -= full;
    if (!clockwise && angle < nearly_nothing) angle += full;
    const double radius = distance(from, *centre);
    Point last = from;
    for (int piece = 1; piece <= pieces; ++piece) {
        const double part = static_cast<double>(piece) / pieces, turn = begin + angle * part;
        const Point next = piece == pieces ? to
                                           : Point{(*centre)[0] + radius * std::cos(turn),
                                                   (*centre)[1] + radius * std::sin(turn)};
        add(step, last, next, z_from + (z_to - z_from) * (part - 1.0 / pieces),
            z_from + (z_to - z_from) * part);
        last = next;
    }
}

void Gatherer::see(const Step& step) {
    if (!is_usable_) return;
    // What a called program cuts is not known here.
    is_usable_ = !step.calls && ways_.size() <= most_ways && !counts_from_elsewhere(step.after, control_);
    const Known& plane = step.after.of(ModalRole::plane);
    const auto planes = control_.group_with(ModalRole::plane);
    if (planes && plane.is_known() && plane.value != control_.groups[*planes].members.front().number)
        is_usable_ = false;
    // G54.1 P1 and P2 are one code, and two frames.
    const Known& frame = step.after.of(ModalRole::work_offset);
    if (frame.is_known() && frame.value != std::floor(frame.value)) is_usable_ = false;
    const auto units = control_.group_with(ModalRole::units);
    const Known& unit = step.after.of(ModalRole::units);
    if (units && unit.is_known()) is_inch_ = unit.is(control_.groups[*units].members.front().number);
    const Position& from = step.before.position;
    Position to = step.after.position;
    const bool drills = step.move == Move::cycle;
    if (step.move != Move::rapid && step.move != Move::feed && !drills) return;
    if (drills) {
        const auto depth = step.words.number(machine_.axes[z_axis]);
        if (!depth) return;
        to[z_axis] = depth->value;
    }
    if (std::ranges::any_of(to, [](double value) { return std::isnan(value); })) return;
    const Point end = {to[x_axis], to[y_axis]};
    const bool begins_somewhere =
        !drills && std::ranges::none_of(from, [](double value) { return std::isnan(value); });
    if (!begins_somewhere) return add(step, end, end, to[z_axis], to[z_axis]);
    const Point start = {from[x_axis], from[y_axis]};
    const bool is_arc = step.move == Move::feed && !step.after.of(ModalRole::motion).is(1);
    if (is_arc)
        add_arc(step, start, end, from[z_axis], to[z_axis]);
    else
        add(step, start, end, from[z_axis], to[z_axis]);
}

} // namespace

Ways ways_of(const Program& program, const States& states) {
    if (states.empty() || program.control->machine_words->x_is_diameter) return {};
    if (count_blocks(program) > most_ways) return {};
    Gatherer gatherer(program);
    states.for_each_step([&](const Step& step) { gatherer.see(step); });
    if (!gatherer.is_usable()) return {};
    return {gatherer.ways(), gatherer.is_inch()};
}

} // namespace maclint::machine
