//! MAC526: a feed that is written for the other feed mode.
#include "rules/machine/feed_size.hpp"
#include "rules/machine_check.hpp"
#include "rules/path.hpp"

#include <algorithm>

namespace maclint::rules {

namespace {
void check(const MachineStep& at, Reporter& reporter);
}

extern const Rule feed_of_the_other_mode{
    .code = "MAC526",
    .name = "feed-of-the-other-mode",
    .summary = "A tool cuts with a feed per minute under feed per revolution, or the other way round",
    .why = "F200 under feed per revolution takes the tool through the work in a few turns; F0.2 under feed "
           "per minute does not move it.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .messages = {{"per_revolution",
                  "Feed of the other mode: '{0}' cuts with F{1} per revolution, by the {2} of line {3}.",
                  "Write {4} before it, or the feed for a revolution."},
                 {"per_minute",
                  "Feed of the other mode: '{0}' cuts with F{1} per minute, by the {2} of line {3}.",
                  "Write {4} before it, or the feed for a minute."}},
    .bad = {{"fanuc", R"nc(
O9526(GROOVE)
G28 U0 W0
G21 G40 G97 G99
T0404
G0 X36. Z-22. M8
G1 X21. F80.
M30
)nc"},
            {"fanuc", R"nc(
O9526(SLOT)
G21 G90 G94 G17 G54
T1 M6
G43 H1 G0 Z2. S3000 M3
G1 Z-5. F0.2
M30
)nc"}},
    .good = {{"fanuc", R"nc(
O9526(GROOVE, THREAD, LIVE DRILL)
G28 U0 W0
G21 G40 G97 G99
T0404
G97 S200 M3
G0 X36. Z-22. M8
G1 X21. F0.08
G0 X60. Z12.
G92 X49. Z-32. F12.
T1111
G98
G0 X80. Z5. C0. M8
G83 Z-20. R-2. Q4000 F120.
G80
G99
M30
)nc"},
             {"fanuc", R"nc(
O9527(TAP, BY ITS LEAD)
G21 G90 G94 G17 G54
T1 M6
G43 H1 Z5.
M29 S600
G95 G84 Z-15. R5. F0.8
G80 G94
M30
)nc"},
             {"fanuc", R"nc(
O9528(NO MODE IS WRITTEN, NOR A UNIT)
G28 U0 W0
T0404
G0 X36. Z-22. M8
G1 X21. F80.
M30
)nc"}},
    .sources = {"T"},
    .check = MachineCheck{&check},
};

namespace {

/// Whether F is a lead there.
bool cuts_by_lead(const MachineStep& at) {
    const MachineWords& letters = at.letters();
    const auto is_one_of = [](std::span<const double> codes, const machine::Known& code) {
        return code.kind == machine::Known::Kind::unknown ||
               std::ranges::find(codes, code.value) != codes.end();
    };
    return at.step.words.has_one_of(letters.threads) || at.step.words.has_one_of(letters.tapping_cycles) ||
           is_one_of(letters.threads, at.after().of(ModalRole::motion)) ||
           is_one_of(letters.tapping_cycles, at.after().of(ModalRole::cycle)) || at.step.words.has('E');
}

void check(const MachineStep& at, Reporter& reporter) {
    const machine::Known& mode = at.after().of(ModalRole::feed_mode);
    const machine::Known& feed = at.after().of(ModalRole::feed);
    if (!at.cuts() || !feed.is_known() || feed.by_call || mode.by_call || cuts_by_lead(at)) return;
    const MachineWords& letters = at.letters();
    const FeedSize size(at.before(), letters);
    const auto group = *at.analysis.control().group_with(ModalRole::feed_mode);
    const auto code = [&](double number) { return at.analysis.control().spell(group, number); };
    if (mode.is(letters.feed_per_revolution)) {
        if (!size.is_too_much_for_a_turn(feed.value) || !at.is_first_of(feed)) return;
        reporter
            .report(at.cause(), at.block(), "per_revolution",
                    {at.quoted_block(), number_word(feed.value), code(letters.feed_per_revolution),
                     at.line_of(mode), code(letters.feed_per_minute)})
            .related.push_back(at.at(mode, "feed per revolution begins here"));
        return;
    }
    if (!mode.is(letters.feed_per_minute)) return;
    if (!size.is_too_little_for_a_minute(feed.value)) return;
    // Where the mode is the wrong one all of its feeds are.
    if (!at.is_first_of(mode)) return;
    reporter
        .report(at.cause(), at.block(), "per_minute",
                {at.quoted_block(), number_word(feed.value), code(letters.feed_per_minute), at.line_of(mode),
                 code(letters.feed_per_revolution)})
        .related.push_back(at.at(mode, "feed per minute begins here"));
}

} // namespace
} // namespace maclint::rules
