//! Holds a profile against where its cycle begins.
#include "rules/machine/profile_check.hpp"

#include "rules/machine/profile_path.hpp"
#include "rules/path.hpp"

#include <cmath>

namespace maclint::rules {
namespace {

bool lies_inside(double start, const std::optional<ProfilePath::Range>& range, double margin) {
    return range && range->least + margin < start && start < range->greatest - margin;
}

} // namespace

void check_profile(const MachineStep& at, Reporter& reporter) {
    const auto& roughing = at.letters().roughing;
    if (roughing.size() < 2 || !at.step.words.has('P') || !at.step.words.has('Q')) return;
    const bool along_z = at.step.words.has_g(roughing[0]);
    if (!along_z && !at.step.words.has_g(roughing[1])) return;
    const auto path = profile_path(at);
    if (!path) return;
    const bool is_inch = at.after().of(ModalRole::units).is(at.letters().inch);
    const double unit = is_inch ? 1 / machine::millimetres_of_inch : 1;
    const double margin = 3 * unit, tolerance = 0.02 * unit;
    const std::string code = "G" + number_word(along_z ? roughing[0] : roughing[1]);
    const auto xs = path->xs(), zs = path->zs();
    const auto inside = [&](const char* axis, double start, const ProfilePath::Range& range) {
        reporter.report(
            at.cause(), at.block(), "inside",
            {code, axis, number_word(start), number_word(range.least), number_word(range.greatest)});
    };
    if (along_z && lies_inside(path->start_x, xs, margin)) return inside("X", path->start_x, *xs);
    if (path->begins_along_one_axis && lies_inside(path->start_z, zs, margin))
        return inside("Z", path->start_z, *zs);
    const auto u = at.step.words.number('U');
    if (along_z && u && xs) {
        const bool is_bore = path->start_x <= xs->least;
        const bool is_outside = path->start_x >= xs->greatest;
        if ((is_bore && u->value > 0) || (is_outside && u->value < 0))
            return void(reporter.report(at.cause(), at.place_of('U'), "side",
                                        {code, number_word(path->start_x), is_bore ? "inside" : "outside",
                                         number_word(u->value), is_bore ? "too wide" : "too thin"}));
    }
    if (!path->begins_along_one_axis) return;
    const auto* back = path->first_back(&ProfilePath::Point::x, tolerance);
    if (back == nullptr) back = path->first_back(&ProfilePath::Point::z, tolerance);
    if (back != nullptr)
        reporter.report({at.analysis, back->block}, back->block, "back",
                        {quoted(at.analysis.program(), back->block), code});
}

} // namespace maclint::rules
