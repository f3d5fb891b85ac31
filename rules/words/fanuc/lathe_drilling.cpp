//! Drilling cycles of Fanuc lathes, for driven tools.
#include "rules/words/cited_lines.hpp"

namespace maclint::code_books {
namespace {

using namespace book;
constexpr TableText of_16i = "FANUC 16i/18i/21i", of_30i = "FANUC 30i/0i-D";
/// Where others that nobody has named write otherwise.
constexpr TableText named = "fanuc-16i fanuc-0i-c fanuc-0i-d fanuc-30i";

constexpr TableText polar = "G12.1 G112";

constexpr TableText no_bottom = "the hole gets no depth, or one of an earlier cycle";
constexpr TableText in_ms = "it counts milliseconds, and the control stops";
constexpr TableText no_polar = "polar interpolation takes no such code";

// What a cycle is told stays until G80. Without Q the hole is drilled in one stroke; some write its number
// with a point.
// clang-format off
constexpr BookLine lines[] = {
    code("G80", "REF-MOD", "end of the drilling cycle"),
    code("G81 G82", "T", "drilling, drilling with a dwell, in the Series 10/11 form"),
        word("X Z Y C U W H V", "T", "position and bottom of the hole"),
        word("R", "T", "level R"),
        word("P", "T", "dwell at the bottom in ms"),
        word("F", "T", "feed").without("feed in force"),
        word("K L", "T", "number of repeats", ">=0").without("1"),
        word("Q", "T", "data of the gear box"),
    code("G83", "BLOG-DRILL", "drilling of the face, in pecks or in one stroke"),
        word("Z W", "BLOG-DRILL", "bottom of the hole"),
        word("X U C H Y V", "BLOG-DRILL", "position of the hole").without("present position"),
        word("R", "BLOG-DRILL", "step from here to level R").without("0"),
        word("Q", "GEDIT", "depth of a peck").without("one stroke"),
        word("P", "BLOG-DRILL", "dwell at the bottom in ms").without("0"),
        word("F", "BLOG-DRILL", "feed").without("feed in force"),
        word("K", "BLOG-DRILL", "number of repeats", ">=0").without("1"),
        word("L", "GEDIT", "number of repeats, in the Series 10/11 form").without("1"),
        word("M", "BLOG-DRILL", "clamp of the C axis"),
        needs("Z W", "BLOG-DRILL", "bottom of the hole", no_bottom).kept(),
        whole("P", "T", in_ms).on(named).alarm(of_16i, "007").alarm(of_30i, "007"),
        refused_under(polar, "GH-ALM", no_polar).on(named).alarm(of_16i, "146").alarm(of_30i, "146"),
    code("G83.1", "T", "high-speed pecking (Series 10/11 form)"),
        word("X Z Y C U W H V", "T", "position and bottom of the hole"),
        word("Q R P F K L", "T", "peck, level R, dwell, feed, repeats"),
    code("G83.5 G83.6 G87.5 G87.6", "T", "pecking of face or side: high-speed, with retraction (30i)"),
        word("X Z Y C U W H V", "T", "position and bottom of the hole"),
        word("Q R P F K L", "T", "peck, level R, dwell, feed, repeats"),
    code("G84", "GEDIT", "tapping of the face"),
        word("Z W", "BLOG-DRILL", "bottom of the hole"),
        word("X U C H Y V", "BLOG-DRILL", "position of the hole").without("present position"),
        word("R", "BLOG-DRILL", "step from here to level R").without("0"),
        word("Q", "GEDIT", "depth of a peck").without("one stroke"),
        word("P", "BLOG-DRILL", "dwell at the bottom in ms").without("0"),
        word("F", "BLOG-DRILL", "feed; lead times speed, or lead").without("feed in force"),
        word("K", "BLOG-DRILL", "number of repeats", ">=0").without("1"),
        word("L", "GEDIT", "number of repeats, in the Series 10/11 form").without("1"),
        word("S", "T", "spindle speed of rigid tapping").without("speed in force"),
        word("J I", "T", "speed on the way out, in the Series 10/11 form"),
        word("M", "BLOG-DRILL", "clamp of the C axis"),
        needs("Z W", "BLOG-DRILL", "bottom of the hole", no_bottom).kept(),
        whole("P", "T", in_ms).on(named).alarm(of_16i, "007").alarm(of_30i, "007"),
        refused_under(polar, "GH-ALM", no_polar).on(named).alarm(of_16i, "146").alarm(of_30i, "146"),
    code("G84.2", "GEDIT", "rigid tapping, in the Series 10/11 form"),
        word("X Z Y C U W H V", "GEDIT", "position and bottom of the hole"),
        word("R", "GEDIT", "level R"),
        word("P", "GEDIT", "dwell in ms"),
        word("F S", "GEDIT", "lead times speed, speed"),
        word("Q J I K L", "T", "peck, speed on the way out, repeats"),
    code("G85", "GEDIT", "boring of the face"),
        word("Z W", "BLOG-DRILL", "bottom of the hole"),
        word("X U C H Y V", "BLOG-DRILL", "position of the hole").without("present position"),
        word("R", "BLOG-DRILL", "step from here to level R").without("0"),
        word("P", "BLOG-DRILL", "dwell at the bottom in ms").without("0"),
        word("F", "BLOG-DRILL", "feed").without("feed in force"),
        word("K", "BLOG-DRILL", "number of repeats", ">=0").without("1"),
        word("L", "GEDIT", "number of repeats, in the Series 10/11 form").without("1"),
        word("M", "BLOG-DRILL", "clamp of the C axis"),
        needs("Z W", "BLOG-DRILL", "bottom of the hole", no_bottom).kept(),
        whole("P", "T", in_ms).on(named).alarm(of_16i, "007").alarm(of_30i, "007"),
        refused_under(polar, "GH-ALM", no_polar).on(named).alarm(of_16i, "146").alarm(of_30i, "146"),
    code("G87", "BLOG-DRILL", "drilling of the side, in pecks or in one stroke"),
        word("X U", "BLOG-DRILL", "bottom of the hole"),
        word("Z W C H Y V", "BLOG-DRILL", "position of the hole").without("present position"),
        word("R", "BLOG-DRILL", "step from here to level R").without("0"),
        word("Q", "GEDIT", "depth of a peck").without("one stroke"),
        word("P", "BLOG-DRILL", "dwell at the bottom in ms").without("0"),
        word("F", "BLOG-DRILL", "feed").without("feed in force"),
        word("K", "BLOG-DRILL", "number of repeats", ">=0").without("1"),
        word("L", "GEDIT", "number of repeats, in the Series 10/11 form").without("1"),
        word("M", "BLOG-DRILL", "clamp of the C axis"),
        needs("X U", "BLOG-DRILL", "bottom of the hole", no_bottom).kept(),
        whole("P", "T", in_ms).on(named).alarm(of_16i, "007").alarm(of_30i, "007"),
        refused_under(polar, "GH-ALM", no_polar).on(named).alarm(of_16i, "146").alarm(of_30i, "146"),
    code("G88", "GEDIT", "tapping of the side"),
        word("X U", "BLOG-DRILL", "bottom of the hole"),
        word("Z W C H Y V", "BLOG-DRILL", "position of the hole").without("present position"),
        word("R", "BLOG-DRILL", "step from here to level R").without("0"),
        word("Q", "GEDIT", "depth of a peck").without("one stroke"),
        word("P", "BLOG-DRILL", "dwell at the bottom in ms").without("0"),
        word("F", "BLOG-DRILL", "feed; lead times speed, or lead").without("feed in force"),
        word("K", "BLOG-DRILL", "number of repeats", ">=0").without("1"),
        word("L", "GEDIT", "number of repeats, in the Series 10/11 form").without("1"),
        word("S", "T", "spindle speed of rigid tapping").without("speed in force"),
        word("J I", "T", "speed on the way out, in the Series 10/11 form"),
        word("M", "BLOG-DRILL", "clamp of the C axis"),
        needs("X U", "BLOG-DRILL", "bottom of the hole", no_bottom).kept(),
        whole("P", "T", in_ms).on(named).alarm(of_16i, "007").alarm(of_30i, "007"),
        refused_under(polar, "GH-ALM", no_polar).on(named).alarm(of_16i, "146").alarm(of_30i, "146"),
    code("G89", "GEDIT", "boring of the side"),
        word("X U", "BLOG-DRILL", "bottom of the hole"),
        word("Z W C H Y V", "BLOG-DRILL", "position of the hole").without("present position"),
        word("R", "BLOG-DRILL", "step from here to level R").without("0"),
        word("P", "BLOG-DRILL", "dwell at the bottom in ms").without("0"),
        word("F", "BLOG-DRILL", "feed").without("feed in force"),
        word("K", "BLOG-DRILL", "number of repeats", ">=0").without("1"),
        word("L", "GEDIT", "number of repeats, in the Series 10/11 form").without("1"),
        word("M", "BLOG-DRILL", "clamp of the C axis"),
        needs("X U", "BLOG-DRILL", "bottom of the hole", no_bottom).kept(),
        whole("P", "T", in_ms).on(named).alarm(of_16i, "007").alarm(of_30i, "007"),
        refused_under(polar, "GH-ALM", no_polar).on(named).alarm(of_16i, "146").alarm(of_30i, "146"),
    code("G80.4 G81.4 G80.5 G81.5", "T", "electronic gear box: off, on (option)"),
        word("P Q R I J K L", "T", "words of the option"),
};
// clang-format on

} // namespace

extern const CodeBook fanuc_lathe_drilling{.language = "fanuc",
                                           .chapter = "drilling cycles of lathes",
                                           .source = "T",
                                           .sections = "",
                                           .machine = Machine::lathe,
                                           .controls = "fanuc fanuc-16i fanuc-0i-c fanuc-0i-d fanuc-30i",
                                           .lines = lines};

} // namespace maclint::code_books
