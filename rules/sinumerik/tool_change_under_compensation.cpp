//! SIN502: the tool is changed while radius compensation is in force.
#include "analyzer/dataflow/facts/point_state.hpp"
#include "rules/rule.hpp"
#include "rules/sinumerik/under_compensation.hpp"

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

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    const Program& program = analysis.program();
    report_under_compensation(analysis, "change", reporter, [&](EffectId id) {
        const auto* change = std::get_if<ToolChange>(&program.effects[id].what);
        return change != nullptr && change->kind == ToolChange::Kind::change;
    });
}

} // namespace
} // namespace maclint::rules
