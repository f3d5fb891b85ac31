//! MAC553: a cut before any feed is given.
#include "rules/machine_check.hpp"
#include "rules/path.hpp"

#include <algorithm>

namespace maclint::rules {

namespace {
void check(const MachineStep& at, Reporter& reporter);
}

extern const Rule feed_missing{
    .code = "MAC553",
    .name = "feed-missing",
    .summary = "A tool cuts before any feed is given, or with a feed of nothing",
    .why = "The control stops at the block, or creeps with what the program before has left.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .messages = {{"none", "No feed: '{0}' cuts, and no F stands before it on any path.",
                  "Give the feed in this block."},
                 {"nothing", "No feed: '{0}' cuts under the F0 of line {1}.",
                  "Give the feed that is meant."}},
    .bad = {{"fanuc", R"nc(
O9553(PLATE)
G90 G17 G54
T1 M6
S3000 M3
G0 X0 Y0
G43 H1 Z5.
G1 Z-5.
X50. F200.
M30
)nc"},
            {"fanuc", R"nc(
O9553(PLATE)
G90 G17 G54
T1 M6
S3000 M3
G0 X0 Y0
G43 H1 Z5.
G1 Z-5. F0
X50. F200.
M30
)nc"}},
    .good = {{"fanuc", R"nc(
O9553(PLATE)
G90 G17 G54
T1 M6
S3000 M3
G0 X0 Y0 F200.
G43 H1 Z5.
G1 Z-5.
X50.
M30
)nc"},
             {"fanuc", R"nc(
O9553(POCKET, CALLED WITH A FEED)
G91 G1 Z-1.
X10.
G90
M99
)nc"}},
    .alarms = {{"FANUC 16i/18i/21i", "011", "NO FEEDRATE COMMANDED", false},
               {"FANUC 30i/0i-D", "011", "FEED ZERO ( COMMAND )", false},
               {"SINUMERIK", "10860", "feed is not programmed", false}},
    .sources = {"T"},
    .check = MachineCheck{&check},
};

namespace {

void check(const MachineStep& at, Reporter& reporter) {
    const auto cuts_with_feed = [](const machine::Left* left) { return left->cuts_with_feed.has_value(); };
    if (!at.cuts() && !std::ranges::any_of(at.called(), cuts_with_feed)) return;
    const machine::State& now = at.after();
    if (!machine::takes_feed(at.step, at.letters())) return;
    const machine::Known& feed = now.of(ModalRole::feed);
    const bool none = feed.is_callers() && at.analysis.is_main();
    if (!(none || feed.is(0)) || !at.habits.is_of_a_machine() || !at.is_first_of(feed)) return;
    reporter.report(at.cause(), at.block(), none ? "none" : "nothing", {at.quoted_block(), at.line_of(feed)});
}

} // namespace
} // namespace maclint::rules
