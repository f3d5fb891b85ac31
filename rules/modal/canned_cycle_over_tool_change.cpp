//! MAC569: a canned cycle that is still in force when the tool is changed or a reference position is
//! approached.
#include "analyzer/dataflow/facts/point_state.hpp"
#include "analyzer/program/tables.hpp"
#include "analyzer/queries/modal/left_active.hpp"
#include "analyzer/queries/modal/modes_at.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/fixes.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"
#include "rules/trace.hpp"

#include <algorithm>
#include <set>
#include <variant>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule canned_cycle_over_tool_change{
    .code = "MAC569",
    .name = "canned-cycle-over-tool-change",
    .summary = "A canned cycle is still in force at a tool change or a reference position return",
    .why = "The next tool drills at every position that it comes to, as deep as the last one. G27 to G30"
           " are not allowed while a cycle is in force: many controls stop there.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .facts = dataflow::facts<dataflow::BeforeNode>(),
    .data_flow = true,
    .messages =
        {{"tool",
          "Canned cycle at a tool change: {0} of line {1} is still in force at '{2}', and the next tool "
          "drills at every position.",
          "Write {3} before it."},
         {"reference",
          "Canned cycle at a reference position return: {0} of line {1} is still in force at '{2}', "
          "where many controls stop.",
          "Write {3} before it."}},
    .bad = {{"fanuc", R"nc(
O9569(HOLES)
T1 M6
G43 H1 Z50.
G98 G81 X10. Y10. Z-12. R2. F150.
X30.
T2 M6
G43 H2 Z50.
G80
M30
)nc"},
            {"fanuc", R"nc(
O9569(HOLES)
T1 M6
G98 G81 X10. Y10. Z-12. R2. F150.
X30.
G91 G28 Z0
G80
M30
)nc"}},
    .good = {{"fanuc", R"nc(
O9569(HOLES)
T1 M6
G98 G81 X10. Y10. Z-12. R2. F150.
X30.
G80
G91 G28 Z0
T2 M6
M30
)nc"}},
    .alarms = {{"FANUC 16i/18i/21i", "044", "G27-G30 NOT ALLOWED IN FIXED CYC", false}},
    .sources = {"T: alarm 044"},
    .check = &check,
};

namespace {

/// The effect at which a cycle must be off, with the message about it.
struct Place {
    EffectId effect;
    std::string_view message;
};

std::optional<Place> place_in(const Program& program, const BlockView& block) {
    for (EffectId id = block.effects.first; id < block.effects.first + block.effects.count; ++id) {
        const auto& what = program.effects[id].what;
        if (const auto* motion = std::get_if<Motion>(&what); motion != nullptr && motion->to_reference)
            return Place{id, "reference"};
        if (std::holds_alternative<ToolChange>(what)) return Place{id, "tool"};
    }
    return std::nullopt;
}

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    const Program& program = analysis.program();
    const auto group = analysis.control().group_with(ModalRole::cycle);
    if (!group) return;
    const ModalGroup& cycle = analysis.control().groups[*group];
    queries::ModesAt modes_at(analysis);
    queries::Lasting lasting(analysis);
    std::set<Offset> reported; // blocks that begin a cycle: one finding for each
    for_each_block_with_effects(program, [&](const BlockView& block) {
        const auto place = place_in(program, block);
        if (!place) return;
        const queries::Modes modes = modes_at(block).with_words(*group);
        if (modes.unknown) return;
        const flow::NodeId node = *analysis.graph().node_of(place->effect);
        for (const queries::Mode& mode : modes.possible) {
            if (mode.set_by != queries::Mode::SetBy::word || !mode.code || mode.code == cycle.cancel)
                continue;
            const Span begun = queries::span_of(analysis, mode);
            if (reported.contains(begun.begin) || !lasting.until(node, *group, mode.node)) continue;
            reported.insert(begun.begin);
            const Span there = program.effects[place->effect].span;
            Finding& finding = reporter.report(
                {analysis, place->effect}, there, place->message,
                {analysis.control().spell(*group, *mode.code), line_number(analysis.file(), begun.begin),
                 quoted(program, there), analysis.control().spell(*group, *cycle.cancel)});
            offer_block_before(finding, Applicability::unsafe, there,
                               analysis.control().spell(*group, *cycle.cancel));
            trace(finding, analysis, mode.node, {analysis.source(), begun, "the cycle begins here"}, node,
                  "it is still in force here");
            return;
        }
    });
}

} // namespace
} // namespace maclint::rules
