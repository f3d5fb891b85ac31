//! MAC522: a circle that cannot be.
#include "analyzer/dataflow/facts/call_begun.hpp"
#include "analyzer/dataflow/facts/point_state.hpp"
#include "analyzer/dataflow/facts/read.hpp"
#include "analyzer/dataflow/facts/store.hpp"
#include "rules/machine/impossible_arc_sizes.hpp"
#include "rules/machine_check.hpp"
#include "rules/path.hpp"

namespace maclint::rules {

namespace {
void check(const MachineStep& at, Reporter& reporter);
}

extern const Rule impossible_arc{
    .code = "MAC522",
    .name = "impossible-arc",
    .summary = "The centre, the radius and the end of an arc do not make a circle",
    .why = "The control stops in the cut, or takes another path than the one that was meant.",
    .severity = Severity::error,
    .precision = Precision::very_high,
    .facts = dataflow::facts<dataflow::BeforeNode, dataflow::CallBegun, dataflow::Read, dataflow::Store>(),
    .messages = {{"radii", "Radii of the arc differ: '{0}' begins {1} from its centre and ends {2} from it.",
                  "Correct its end, or the centre in {3}."},
                 {"chord",
                  "Radius too small: '{0}' ends {1} from where it begins, and {2} reaches {3} at most.",
                  "Correct the radius, or the end."},
                 {"zero", "Radius of 0: '{0}' is no arc.", "Write the radius, or the centre in {1}."},
                 {"at-start", "Centre at the start of the arc: '{0}' has a radius of 0.",
                  "Correct the centre in {1}: it counts from the start."},
                 {"sizes",
                  "Two sizes in one circle: '{0}' begins and ends at one distance from its centre only where "
                  "{1} and {2} are equal.",
                  "Write one of them in both places, or check that they are."},
                 {"never", "No circle: '{0}' begins and ends at different distances from its centre{1}.",
                  "Correct its end, or the centre."},
                 {"no-centre", "Arc without a centre: '{0}' has neither a centre nor a radius.",
                  "Write the centre or {1}=, or G1 where a straight line is meant."},
                 {"other-plane",
                  "Centre of another plane: '{0}' stands in an arc under {1}, whose centre is in {2}.",
                  "Write {2}, or choose the plane before."}},
    .bad = {{"fanuc", R"nc(
O9522(POCKET)
G17 G90 G21 G0 X10. Y0
G1 Y30. F200.
G2 X30. Y50. R1.
X20. Y40. R0
X10. Y30. I0 J0
X40. Y60. I12. J0
M30
)nc"},
            {"fanuc", R"nc(
O9522(ROUND EDGE)
G18 G90 G21 G0 X10. Z0
G1 Z-10. F200.
G2 X20. Z-20. I10. J2.
M30
)nc"},
            {"fanuc", R"nc(
O9523(CORNER, A WAY OF APPROACH, R RADIUS)
G91 G3 X#1 Y#1 I0 J#18 F200.
G90
M99
)nc"}},
    .good = {{"fanuc", R"nc(
O9522(POCKET)
G17 G90 G21 G0 X10. Y0
G1 Y30. F200.
G2 X20. Y40. I10. J0
G2 X30. Y30. R10.
G3 I-10. Z-1.
M30
)nc"},
             {"fanuc", R"nc(
O9522(CENTRES FROM THE ZERO OF THE PART)
G17 G90 G21 G0 X10. Y0
G1 Y30. F200.
G2 X20. Y40. I20. J30.
M30
)nc"}},
    .alarms = {{"FANUC 16i/18i/21i", "020", "OVER TOLERANCE OF RADIUS", false, "radii"},
               {"FANUC 30i/0i-D", "020", "OVER TOLERANCE OF RADIUS", false, "radii"},
               {"FANUC 16i/18i/21i", "021", "ILLEGAL PLANE AXIS COMMANDED", false, "other-plane"},
               {"FANUC 30i/0i-D", "021", "ILLEGAL PLANE SELECT", false, "other-plane"},
               {"SINUMERIK", "14040", "error in the end point of a circle", false, "radii never"},
               {"SINUMERIK", "14095", "circle radius too small", false}},
    .sources = {"CSDN-PS: alarms 020, 021, parameter 3410", "GH-ALM", "T: radius and chord"},
    .check = MachineCheck{.check = &check, .with_numbers_of_calls = true},
};

namespace {

void check(const MachineStep& at, Reporter& reporter) {
    report_wrong_sizes(at, reporter);
    const machine::Arc* arc = at.habits.wrong_arc(at.step.block.span.begin);
    if (arc == nullptr) return;
    const std::string block = at.quoted_block();
    const std::string first = length_word(arc->first), second = length_word(arc->second);
    const Span word = at.place_of(arc->letter);
    switch (arc->fault) {
        using enum machine::ArcFault;
    case none:
    case nothing_moves: return;
    case radii:
        reporter.report(at.cause(), at.block(), "radii", {block, first, second, arc->letters});
        return;
    case chord:
        reporter.report(at.cause(), word, "chord",
                        {block, first, quoted(at.analysis.program(), word), second});
        return;
    case zero_radius: reporter.report(at.cause(), word, "zero", {block, arc->letters}); return;
    case centre_at_start: reporter.report(at.cause(), at.block(), "at-start", {block, arc->letters}); return;
    case no_centre: reporter.report(at.cause(), at.block(), "no-centre", {block, arc->letters}); return;
    case other_plane: break;
    }
    const machine::Known& plane = at.after().of(ModalRole::plane);
    // Where the whole arc lies in another plane, its code is missing, and that once.
    if (arc->leaves_plane && !at.is_first_of(plane)) return;
    // Who calls a program may have said the plane for it.
    const bool is_said = !arc->plane_of_start;
    if (!is_said && arc->leaves_plane && !at.analysis.is_main()) return;
    const char* start = at.letters().x_is_diameter ? "the plane of Z and X" : "the plane of X and Y";
    Finding& finding =
        reporter.report(at.cause(), word, "other-plane",
                        {quoted(at.analysis.program(), word),
                         is_said ? at.spelled(at.after(), ModalRole::plane) : start, arc->letters});
    if (!is_said) finding.severity = Severity::warning, finding.alarm = {};
}

} // namespace
} // namespace maclint::rules
