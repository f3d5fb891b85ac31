//! MAC535: the plane changes while cutter compensation is in force.
#include "analyzer/program/tables.hpp"
#include "analyzer/queries/modal/modes_at.hpp"
#include "analyzer/queries/modal/own_settings.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"
#include "rules/trace.hpp"

#include <algorithm>
#include <optional>
#include <set>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule plane_changed_under_compensation{
    .code = "MAC535",
    .name = "plane-changed-under-compensation",
    .summary = "The plane changes while cutter compensation is in force",
    .why = "Compensation moves the tool aside in the plane in which it was switched on. The control stops at "
           "the "
           "code of another plane.",
    .severity = Severity::error,
    .precision = Precision::high,
    .yields_to = "DIN619",
    .facts = dataflow::facts<dataflow::BeforeNode>(),
    .data_flow = true,
    .messages = {{"plane",
                  "Plane changed under compensation: {0} takes effect while {1} of line {2} is in force.",
                  "Write {3} into a straight move before it."}},
    .bad = {{"fanuc", R"nc(
O9535(POCKET AND SLOT)
G17 G90 G40
G0 X-10. Y0
G41 D1 G1 X5. F200.
Y30.
G18
G3 X20. Z-5. R30.
G40 G1 X40.
G17
M99
)nc"},
            {"sinumerik", R"nc(
G17 G90 G54
G0 X-10 Y0
G41 G1 X5 F200
Y30
G18
G1 Z-5
G40 G1 X40
M30
)nc"}},
    .good = {{"fanuc", R"nc(
O9535(POCKET AND SLOT)
G17 G90 G40
G0 X-10. Y0
G41 D1 G1 X5. F200.
Y30.
G40 G1 X-10.
G18
G3 X20. Z-5. R30.
G17
M99
)nc"}},
    .alarms = {{"FANUC 16i/18i/21i", "037", "CAN NOT CHANGE PLANE IN CRC"},
               {"FANUC 30i/0i-D", "037", "CAN NOT CHANGE PLANE IN G41/G42"},
               {"SINUMERIK", "10757", "change of the compensation plane while tool radius compensation is on",
                false}},
    .sources = {"GH-ALM", "T: 10757"},
    .check = &check,
};

namespace {

/// What the words of the block change it to, where that and what it was before are known.
std::optional<double> changed_to(const queries::BlockModes& modes, GroupId plane) {
    const auto before = modes.before(plane).sure_code(), after = modes.with_words(plane).sure_code();
    return before && after && *before != *after ? after : std::nullopt;
}

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    const ControlModel& control = analysis.control();
    const auto plane = control.group_with(ModalRole::plane);
    const auto compensation = control.group_with(ModalRole::cutter_compensation);
    if (!plane || !compensation || !control.groups[*compensation].cancel) return;
    const double off = *control.groups[*compensation].cancel;
    queries::ModesAt modes_at(analysis);
    std::set<Offset> reported; // blocks that switch it on: one finding for each
    for_each_block_that_sets(analysis.program(), *plane, [&](const BlockView& block) {
        const queries::BlockModes modes = modes_at(block);
        const auto to = changed_to(modes, *plane);
        const auto node = analysis.graph().node_of(block.span);
        if (!to || !node) return;
        const queries::Modes in_force = modes.with_words(*compensation);
        const bool is_sure = std::ranges::all_of(in_force.possible, [&](const queries::Mode& mode) {
            return mode.set_by == queries::Mode::SetBy::word && mode.code && *mode.code != off;
        });
        if (in_force.unknown || in_force.possible.empty() || !is_sure) return;
        const queries::Mode& mode = in_force.possible.front();
        const Span begun = queries::span_of(analysis, mode);
        if (!reported.insert(begun.begin).second) return;
        Finding& finding = reporter.report(
            mode.origin != 0 ? cause_at(analysis, mode.origin) : Cause{analysis, begun}, block.span, "plane",
            {control.spell(*plane, *to), control.spell(*compensation, *mode.code),
             line_number(analysis.file(), begun.begin), control.spell(*compensation, off)});
        trace(finding, analysis, mode.node, {analysis.source(), begun, "compensation begins here"}, *node,
              "the plane changes here");
    });
}

} // namespace
} // namespace maclint::rules
