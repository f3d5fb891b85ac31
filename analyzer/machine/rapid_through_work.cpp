//! Holds the rapid moves at a depth against the moves that cut.
#include "analyzer/machine/rapid_through_work.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace maclint::machine {
namespace {

/// So near runs a cut along the same line; so near has its tool taken away what is there. In mm.
constexpr double on_line = 0.3, beside_cut = 1.5;

/// Holds one rapid move against all cuts.
class Judge {
  public:
    Judge(const std::vector<Way>& ways, double unit)
        : ways_(ways)
        , on_line_(on_line / unit)
        , beside_cut_(beside_cut / unit) {}

    [[nodiscard]] bool is_at_depth(std::size_t index) const;
    /// Of one at a depth.
    [[nodiscard]] std::optional<RapidThroughWork> judge(std::size_t index) const;

  private:
    [[nodiscard]] bool came_down(std::size_t index) const;
    [[nodiscard]] bool was_cut(const Point& point, std::size_t before, double z) const;
    [[nodiscard]] bool may_meet(const Way& a, const Way& b) const;
    [[nodiscard]] const Way* cut_across(const Way& rapid, std::size_t index) const;
    [[nodiscard]] const Way* cut_along(const Way& rapid, std::size_t index) const;
    [[nodiscard]] bool is_lifted_elsewhere(std::size_t index) const;
    [[nodiscard]] bool lies_within_cuts(const Way& rapid) const;
    [[nodiscard]] std::vector<Point> points_of(const Way& rapid, const Way& other) const;

    const std::vector<Way>& ways_;
    double on_line_, beside_cut_;
    static constexpr double same = 1e-6, half = 0.5;
    static constexpr int parts = 20;
};

/// Whether the tool has last moved down, and not up.
bool Judge::came_down(std::size_t index) const {
    for (std::size_t i = index; i-- > 0;)
        if (std::abs(ways_[i].z_to - ways_[i].z_from) > same || i == 0 || ways_[i].tool != ways_[index].tool)
            return ways_[i].tool == ways_[index].tool && ways_[i].z_to < ways_[i].z_from;
    return false;
}

bool Judge::was_cut(const Point& point, std::size_t before, double z) const {
    return std::any_of(ways_.begin(), ways_.begin() + static_cast<std::ptrdiff_t>(before),
                       [&](const Way& cut) {
                           return cut.cuts && cut.frame == ways_[before].frame && cut.lower() <= z + same &&
                                  distance(point, cut) < beside_cut_;
                       });
}

/// Whether the fields in which two ways lie meet.
bool Judge::may_meet(const Way& a, const Way& b) const {
    const auto reach = [&](std::size_t axis) {
        const auto [a_least, a_most] = std::minmax(a.from[axis], a.to[axis]);
        const auto [b_least, b_most] = std::minmax(b.from[axis], b.to[axis]);
        return a_least - b_most < on_line_ && b_least - a_most < on_line_;
    };
    return reach(0) && reach(1);
}

/// Points of the rapid move away from its ends, and where the other one crosses it.
std::vector<Point> Judge::points_of(const Way& rapid, const Way& other) const {
    std::vector<Point> points;
    for (int part = 1; part < parts; ++part)
        points.push_back(between(rapid.from, rapid.to, static_cast<double>(part) / parts));
    const double ax = rapid.to[0] - rapid.from[0], ay = rapid.to[1] - rapid.from[1];
    const double bx = other.to[0] - other.from[0], by = other.to[1] - other.from[1];
    const double cross = ax * by - ay * bx;
    if (cross == 0) return points;
    const double part = ((other.from[0] - rapid.from[0]) * by - (other.from[1] - rapid.from[1]) * bx) / cross;
    if (part > 0 && part < 1) points.push_back(between(rapid.from, rapid.to, part));
    return points;
}

/// A cut behind it, as high or higher, that crosses it where nothing was cut before.
const Way* Judge::cut_across(const Way& rapid, std::size_t index) const {
    for (std::size_t i = index + 1; i < ways_.size(); ++i) {
        const Way& cut = ways_[i];
        if (!cut.cuts || cut.frame != rapid.frame || !may_meet(rapid, cut) || cut.higher() >= 0 ||
            cut.higher() < rapid.higher() - same)
            continue;
        for (const Point& point : points_of(rapid, cut))
            if (distance(point, cut) < on_line_ && distance(point, rapid.from) > beside_cut_ &&
                distance(point, rapid.to) > beside_cut_ && !was_cut(point, index, rapid.higher()))
                return &cut;
    }
    return nullptr;
}

/// A cut of this tool before it, less deep, along most of it, where nothing was cut so deep.
const Way* Judge::cut_along(const Way& rapid, std::size_t index) const {
    for (std::size_t i = 0; i < index; ++i) {
        const Way& cut = ways_[i];
        if (!cut.cuts || cut.frame != rapid.frame || !may_meet(rapid, cut) || cut.tool != rapid.tool ||
            cut.lower() <= rapid.higher() + same)
            continue;
        int along = 0;
        for (int part = 1; part < parts; ++part) {
            const Point point = between(rapid.from, rapid.to, static_cast<double>(part) / parts);
            if (distance(point, cut) < on_line_ && !was_cut(point, index, rapid.higher())) ++along;
        }
        if (along > parts / 2) return &cut;
    }
    return nullptr;
}

/// Whether the tool goes up behind all of its other cuts, some at least, before it moves on rapidly.
bool Judge::is_lifted_elsewhere(std::size_t index) const {
    constexpr int some = 2;
    int lifts = 0;
    for (std::size_t i = 1; i < ways_.size(); ++i) {
        const Way& way = ways_[i];
        if (way.cuts || !ways_[i - 1].cuts || way.tool != ways_[index].tool || i == index) continue;
        if (way.z_to <= way.z_from) return false;
        ++lifts;
    }
    return lifts >= some;
}

/// Whether both of its ends lie well within the field in which the program cuts.
bool Judge::lies_within_cuts(const Way& rapid) const {
    for (const std::size_t axis : {0U, 1U}) {
        double least = rapid.from[axis], most = least;
        for (const Way& cut : ways_) {
            if (!cut.cuts || cut.frame != rapid.frame) continue;
            least = std::min({least, cut.from[axis], cut.to[axis]});
            most = std::max({most, cut.from[axis], cut.to[axis]});
        }
        for (const double end : {rapid.from[axis], rapid.to[axis]})
            if (end - least < beside_cut_ || most - end < beside_cut_) return false;
    }
    return true;
}

/// Whether it moves sideways at a depth to which the tool has come down.
bool Judge::is_at_depth(std::size_t index) const {
    const Way& rapid = ways_[index];
    return !rapid.cuts && rapid.from != rapid.to && rapid.z_to <= rapid.z_from && rapid.higher() < 0 &&
           came_down(index);
}

std::optional<RapidThroughWork> Judge::judge(std::size_t index) const {
    const Way& rapid = ways_[index];
    using Evidence = RapidThroughWork::Evidence;
    if (const Way* cut = cut_across(rapid, index))
        return RapidThroughWork{rapid.block, rapid.higher(), cut->block, Evidence::cut_later};
    if (const Way* cut = cut_along(rapid, index))
        return RapidThroughWork{rapid.block, rapid.higher(), cut->block, Evidence::cut_less_deep};
    const bool is_between_cuts = index > 0 && index + 1 < ways_.size() && ways_[index - 1].cuts &&
                                 ways_[index + 1].cuts && ways_[index + 1].tool == rapid.tool;
    if (is_between_cuts && is_lifted_elsewhere(index) && lies_within_cuts(rapid) &&
        !was_cut(between(rapid.from, rapid.to, half), index, rapid.higher()))
        return RapidThroughWork{rapid.block, rapid.higher(), ways_[index - 1].block, Evidence::not_lifted};
    return std::nullopt;
}

} // namespace

std::vector<RapidThroughWork> rapid_moves_through_work(const Program& program, const States& states) {
    const Ways ways = ways_of(program, states);
    const Judge judge(ways.ways, ways.in_inches ? millimetres_of_inch : 1);
    // A program with more of them has another way with depths.
    constexpr std::size_t most = 100;
    std::vector<std::size_t> at_depth;
    for (std::size_t i = 0; i < ways.ways.size() && at_depth.size() <= most; ++i)
        if (judge.is_at_depth(i)) at_depth.push_back(i);
    std::vector<RapidThroughWork> found;
    if (at_depth.size() > most) return found;
    for (const std::size_t i : at_depth)
        if (auto rapid = judge.judge(i)) found.push_back(*rapid);
    return found;
}

} // namespace maclint::machine
