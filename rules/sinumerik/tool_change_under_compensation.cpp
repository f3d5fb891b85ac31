//! SIN502: the tool is changed while radius compensation is in force.
#include "analyzer/dataflow/facts/point_state.hpp"
#include "analyzer/machine/states.hpp"
#include "analyzer/program/block_view.hpp"
#include "analyzer/program/tables.hpp"
#include "analyzer/queries/calls/brought_cycles.hpp"
#include "rules/rule.hpp"
#include "rules/sinumerik/under_compensation.hpp"

#include <algorithm>
#include <map>
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
)nc"},
            {"sinumerik", R"nc(
G18 G90 G54 G95 DIAMON
T="ROUGH_80" D1
G42 G1 X20 Z0 F0.2
Z-30
G0 X120 Z80
T="FINISH_35" D1
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

/// Where no M6 changes the tool, and no called program may hold one, the turret turns at T.
bool changes_by_its_number(const Program& program) {
    return !queries::calls_programs(program) &&
           std::ranges::none_of(program.effects, [](const Effect& effect) {
               return std::holds_alternative<ToolChange>(effect.what);
           });
}

/// Blocks with words for the group, by their beginnings.
std::map<Offset, Span> settings_of(const Program& program, GroupId group) {
    std::map<Offset, Span> blocks;
    for_each_block_that_sets(program, group,
                             [&](const BlockView& block) { blocks.emplace(block.span.begin, block.span); });
    return blocks;
}

/// T alone may make the next tool ready; with D it is put to use.
void check_turrets(const ProgramAnalysis& analysis, Reporter& reporter) {
    const ControlModel& control = analysis.control();
    const auto group = control.group_with(ModalRole::cutter_compensation);
    if (!group || !changes_by_its_number(analysis.program())) return;
    std::map<Offset, Span> begun = settings_of(analysis.program(), *group); // one finding for each
    if (begun.empty()) return;
    analysis.machine().for_each_step([&](const machine::Step& step) {
        const machine::Known& on = step.before.of(ModalRole::cutter_compensation);
        const auto block = begun.find(on.block);
        if (!step.words.has('T') || !step.words.has('D') || block == begun.end() ||
            !machine::is_surely_on(step.before, control, ModalRole::cutter_compensation))
            return;
        const flow::Graph& graph = analysis.graph();
        report_stretch(analysis, "change", reporter,
                       {on.value, block->second, *graph.node_of(block->second), step.words.span(),
                        *graph.node_of(step.block.span)});
        begun.erase(block);
    });
}

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    const Program& program = analysis.program();
    report_under_compensation(analysis, "change", reporter, [&](EffectId id) {
        const auto* change = std::get_if<ToolChange>(&program.effects[id].what);
        return change != nullptr && change->kind == ToolChange::Kind::change;
    });
    check_turrets(analysis, reporter);
}

} // namespace
} // namespace maclint::rules
