//! MAC511: cutter compensation that is switched on, off or over in a block that moves on an arc.
#include "analyzer/dataflow/facts/point_state.hpp"
#include "analyzer/program/tables.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/modal/compensation_started_on_arc_finder.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"
#include "rules/trace.hpp"

#include <string>
#include <string_view>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule compensation_started_on_arc{
    .code = "MAC511",
    .name = "compensation-started-on-arc",
    .aliases = "MAC512",
    .summary = "Cutter compensation is switched on, off or over in a block that moves on an arc",
    .why = "The tool comes to its path, and leaves it, in a straight move: the control stops in the arc."
           " Where it takes the other side in an arc, the tool cuts through the contour.",
    .severity = Severity::error,
    .precision = Precision::very_high,
    .facts = dataflow::facts<dataflow::BeforeNode>(),
    .data_flow = true,
    .messages =
        {{"on",
          "Compensation switched on in an arc: '{0}' starts it while {1} is in force, where only a "
          "straight move may.",
          "Write {0} in a straight move before the arc."},
         {"off",
          "Compensation switched off in an arc: '{0}' ends it while {1} is in force, where only a "
          "straight move may.",
          "Write {0} in a straight move after the arc."},
         {"over",
          "Compensation switched over in an arc: '{0}' changes the side while {1} is in force, and the "
          "tool crosses the contour.",
          "Switch it off in a straight move, and on again in another one."},
         {"side",
          "Side of the compensation changed: '{0}' follows on the other side, with no code that ends it "
          "between.",
          "Switch it off in a straight move, and on again in another one."}},
    .bad = {{"fanuc", R"nc(
O9511(POCKET)
G17 G90 G40
G0 X0 Y0
G41 D1 G3 X20. Y0 R10. F200.
G1 Y30.
G40 X0
M30
)nc"},
            {"sinumerik", R"nc(
G17 G90 G40 G54
G0 X-20 Y-20
G41 G1 X0 Y0 F200
Y20
G42 X20
Y0
G40 X40
M30
)nc"}},
    .good = {{"fanuc", R"nc(
O9511(POCKET)
G17 G90 G40
G0 X0 Y0
G41 D1 G1 X5. F200.
G3 X20. Y0 R10.
G1 Y30.
G40 X0
M30
)nc"}},
    .alarms = {{"FANUC 16i/18i/21i", "034", "NO CIRC ALLOWED IN ST-UP /EXT BLK"},
               {"FANUC 30i/0i-D", "034", "NO CIRC ALLOWED IN ST-UP /EXT BLK"},
               {"SINUMERIK", "10753", "tool radius compensation switched on in a block that is not linear",
                false},
               {"SINUMERIK", "10754", "tool radius compensation switched off in a block that is not linear",
                false}},
    .sources = {"T: alarm 034", "SEED-003:12681, 12717"},
    .check = &check,
};

namespace {

std::string_view message_of(CompensationChange::Kind kind) {
    using Kind = CompensationChange::Kind;
    switch (kind) {
    case Kind::on: return "on";
    case Kind::off: return "off";
    case Kind::side: return "side";
    case Kind::over: break;
    }
    return "over";
}

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    for_each_compensation_change_in_arc(analysis, [&](const CompensationChange& change) {
        const ControlModel& control = analysis.control();
        Finding& finding = reporter.report(
            {analysis, change.block}, change.block, message_of(change.kind),
            {control.spell(change.group, change.code), control.spell(change.motion, change.moved)});
        // In an arc it is allowed, and seldom meant.
        if (change.kind == CompensationChange::Kind::over) {
            finding.severity = Severity::warning;
            finding.alarm = {};
        }
        const std::string ends = "the compensation changes here";
        if (change.begins)
            trace(finding, analysis, change.begins->node,
                  {analysis.source(), queries::span_of(analysis, *change.begins), "this is in force"},
                  change.node, ends);
        else
            trace(finding, analysis, change.node, ends);
    });
}

} // namespace
} // namespace maclint::rules
