//! SIN502: the tool is changed while radius compensation is in force.
#include "analyzer/dataflow/facts/point_state.hpp"
#include "analyzer/program/tables.hpp"
#include "analyzer/queries/modal/left_active.hpp"
#include "analyzer/queries/modal/modes_at.hpp"
#include "analyzer/workspace/program_analysis.hpp"
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

extern const Rule tool_change_under_compensation{
    .code = "SIN502",
    .name = "tool-change-under-compensation",
    .summary = "The tool is changed while radius compensation is in force",
    .why =
        "The path of one tool cannot go on with the radius of another: the control stops with an alarm at the"
        " change, or takes the next move for one of the contour.",
    .severity = Severity::error,
    .precision = Precision::high,
    .needs = {Capability::paired_words},
    .facts = dataflow::facts<dataflow::BeforeNode>(),
    .data_flow = true,
    .messages = {{"change", "Tool change under compensation: {0} of line {1} is still in force at '{2}'.",
                  "Write {3} into a straight move away from the contour before it."}},
    .bad = {{"sinumerik", R"nc(
G17 G90 G54
G0 X-30 Y-30
G41 G1 X0 Y-10 F500
Y60
X80
G0 Z50
M6
G40
M30
)nc"}},
    .good = {{"sinumerik", R"nc(
G17 G90 G54
G0 X-30 Y-30
G41 G1 X0 Y-10 F500
Y60
G40 G1 X-30
G0 Z50
M6
M30
)nc"}},
    .sources = {"SEED-004:246"},
    .check = &check,
};

namespace {

std::optional<EffectId> change_in(const Program& program, const BlockView& block) {
    for (EffectId id = block.effects.first; id < block.effects.first + block.effects.count; ++id) {
        const auto* change = std::get_if<ToolChange>(&program.effects[id].what);
        if (change != nullptr && change->kind == ToolChange::Kind::change) return id;
    }
    return std::nullopt;
}

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    const Program& program = analysis.program();
    const auto group = analysis.control().group_with(ModalRole::cutter_compensation);
    if (!group) return;
    const std::optional<double> off = analysis.control().groups[*group].cancel;
    queries::ModesAt modes_at(analysis);
    queries::Lasting lasting(analysis);
    std::set<Offset> reported; // blocks that begin it: one finding for each
    for_each_block_with_effects(program, [&](const BlockView& block) {
        const auto change = change_in(program, block);
        if (!change) return;
        const queries::Modes modes = modes_at(block).with_words(*group);
        if (modes.unknown) return;
        const flow::NodeId node = *analysis.graph().node_of(*change);
        for (const queries::Mode& mode : modes.possible) {
            if (mode.set_by != queries::Mode::SetBy::word || !mode.code || mode.code == off) continue;
            const Span begun = queries::span_of(analysis, mode);
            if (!lasting.until(node, *group, mode.node) || !reported.insert(begun.begin).second) continue;
            const Span there = program.effects[*change].span;
            Finding& finding = reporter.report(
                {analysis, *change}, there, "change",
                {analysis.control().spell(*group, *mode.code), line_number(analysis.file(), begun.begin),
                 quoted(program, there), analysis.control().spell(*group, *off)});
            trace(finding, analysis, mode.node, {analysis.source(), begun, "compensation begins here"}, node,
                  "it is still in force here");
            return;
        }
    });
}

} // namespace
} // namespace maclint::rules
