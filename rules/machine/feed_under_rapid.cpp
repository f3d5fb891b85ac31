//! MAC585: a feed beside an end point, while rapid traverse is still in force.
#include "rules/machine_check.hpp"
#include "rules/path.hpp"

#include <algorithm>

namespace maclint::rules {

namespace {
void check(const MachineStep& at, Reporter& reporter);
}

extern const Rule feed_under_rapid{
    .code = "MAC585",
    .name = "feed-under-rapid",
    .summary = "A block gives a feed and an end point while the rapid traverse of a block before is in force",
    .why = "The feed says that a cut is meant, and the tool goes there at rapid traverse: into the work.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .messages = {{"rapid", "Cut at rapid traverse: '{0}' has a feed, and {1} of line {2} is still in force.",
                  "Write G1 into this block."}},
    .bad = {{"fanuc", R"nc(
O9585(SLOT)
G21 G17 G90 G54 G0 X10. Y10.
G43 H1 Z50. S2000 M3
Z2.
Z-4. F90.
G1 X60. F250.
G0 Z50.
M30
)nc"}},
    .good = {{"fanuc", R"nc(
O9585(SLOT)
G21 G17 G90 G54 G0 X10. Y10.
G43 H1 Z50. S2000 M3
Z2. F90.
G0 Z-1. F90.
F100.
G1 Z-4.
X60. F250.
G0 Z50.
M30
)nc"}},
    .sources = {"T"},
    .check = MachineCheck{&check},
};

namespace {

/// Whether the block holds nothing that may say itself how its axes move.
bool only_moves(const MachineStep& at) {
    constexpr double incremental = 91;
    const MachineWords& letters = at.letters();
    return !at.step.calls && !at.step.words.has_computed_code() && !at.step.words.has_computed_function() &&
           std::ranges::all_of(
               at.step.words.g_codes(),
               [&](double code) { return code == letters.absolute || code == incremental; }) &&
           std::ranges::all_of(at.step.words.m_codes(), [&](double code) {
               return std::ranges::find(letters.aside, code) != letters.aside.end();
           });
}

/// Whether the end point lies in the work: below its zero, or beyond the centre of a lathe.
bool ends_in_work(const MachineStep& at) {
    constexpr std::size_t x = 0, z = 2;
    const machine::Position& end = at.after().position;
    return end[z] < 0 || (at.letters().x_is_diameter && at.step.axes[x] && end[x] <= 0);
}

void check(const MachineStep& at, Reporter& reporter) {
    const machine::Known& motion = at.after().of(ModalRole::motion);
    if (at.step.move != machine::Move::rapid || !at.step.words.has('F') || !only_moves(at)) return;
    if (std::ranges::none_of(at.step.axes, [](bool named) { return named; }) || !ends_in_work(at)) return;
    if (!motion.is(at.letters().rapid) || at.is_on(at.after(), ModalRole::macro_call)) return;
    reporter
        .report(at.cause(), at.place_of('F'), "rapid",
                {at.quoted_block(), at.spelled(at.after(), ModalRole::motion), at.line_of(motion)})
        .related.push_back(at.at(motion, "the rapid traverse begins here"));
}

} // namespace
} // namespace maclint::rules
