//! Follows the blocks between P and Q.
#include "rules/machine/profile_path.hpp"

#include "analyzer/queries/words/enclosed_blocks.hpp"

#include <algorithm>
#include <cmath>

namespace maclint {
namespace {

using machine::nowhere;
constexpr std::size_t x_axis = 0, z_axis = 2;

std::optional<Span> only_block(const MachineStep& at, char letter) {
    const Word* word = at.step.words.word(letter);
    const auto number = word == nullptr ? std::nullopt : queries::block_number(*word);
    if (!number) return std::nullopt;
    const auto places = queries::blocks_numbered(at.analysis.program(), *number);
    return places.size() == 1 ? std::optional(places.front()) : std::nullopt;
}

/// Follows the moves of blocks that nobody runs one by one.
class Follower {
  public:
    Follower(const MachineStep& at, ProfilePath& path)
        : letters_(at.letters())
        , path_(path)
        , x_(path.start_x)
        , z_(path.start_z) {
        const bool has_distance = at.analysis.control().group_with(ModalRole::distance).has_value();
        const machine::Known& distance = at.after().of(ModalRole::distance);
        is_absolute_ = !has_distance || distance.is(letters_.absolute) || distance.is_callers();
    }

    void take(const BlockView& block, const machine::Words& words, bool has_corner_words) {
        const bool moves_x = move(words, x_axis, x_), moves_z = move(words, z_axis, z_);
        if (has_corner_words) x_ = z_ = nowhere; // an angle gives one of them
        if (path_.points.empty()) path_.begins_along_one_axis = moves_x != moves_z;
        const char u = letters_.increments[x_axis];
        is_retreat_ = words.has_g(letters_.rapid) || (u != 0 && words.has(u));
        path_.points.push_back({x_, z_, block.span});
    }

    void end() {
        if (is_retreat_ && !path_.points.empty()) path_.points.pop_back();
    }

  private:
    /// Whether the block has a word of the axis.
    bool move(const machine::Words& words, std::size_t axis, double& place) const {
        const char step = letters_.increments[axis], target = letters_.axes[axis];
        const bool by_step = step != 0 && words.has(step);
        if (!by_step && !words.has(target)) return false;
        const auto number = words.number(by_step ? step : target);
        const bool is_usable = number && number->is_length();
        if (!is_usable)
            place = nowhere;
        else
            place = by_step || !is_absolute_ ? place + number->value : number->value;
        return true;
    }

    const MachineWords& letters_;
    ProfilePath& path_;
    double x_, z_;
    bool is_absolute_ = true, is_retreat_ = false;
};

} // namespace

std::optional<ProfilePath::Range> ProfilePath::range_of(double Point::*axis) const {
    if (points.empty()) return std::nullopt;
    Range range{points.front().*axis, points.front().*axis};
    for (const Point& point : points) {
        if (std::isnan(point.*axis)) return std::nullopt;
        range.least = std::min(range.least, point.*axis);
        range.greatest = std::max(range.greatest, point.*axis);
    }
    return range.least < range.greatest ? std::optional(range) : std::nullopt;
}

const ProfilePath::Point* ProfilePath::first_back(double Point::*axis, double tolerance) const {
    if (points.size() < 3 || !range_of(axis)) return nullptr;
    const double way = points.back().*axis - points.front().*axis;
    for (std::size_t i = 1; i < points.size(); ++i) {
        const double step = points[i].*axis - points[i - 1].*axis;
        if (std::abs(step) > tolerance && step * way < 0) return &points[i];
    }
    return nullptr;
}

std::optional<ProfilePath> profile_path(const MachineStep& at) {
    const auto first = only_block(at, 'P'), last = only_block(at, 'Q');
    if (!first || !last || last->begin < first->begin) return std::nullopt;
    ProfilePath path{at.before().position[x_axis], at.before().position[z_axis], {}, false};
    Follower follower(at, path);
    queries::for_each_block_in(at.analysis.program(), {first->begin, last->end},
                               [&](const BlockView& block, std::span<const Word> words) {
                                   const bool has_angle = std::ranges::any_of(words, [](const Word& word) {
                                       return word.address.starts_with(',') || word.address == "A" ||
                                              word.address == "C";
                                   });
                                   follower.take(block, machine::Words(words, at.letters()), has_angle);
                               });
    follower.end();
    return path;
}

} // namespace maclint
