//! SIN501: the control stops reading ahead while radius compensation is in force.
#include "analyzer/dataflow/facts/point_state.hpp"
#include "rules/rule.hpp"
#include "rules/sinumerik/under_compensation.hpp"

#include <variant>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule stop_under_compensation{
    .code = "SIN501",
    .name = "stop-under-compensation",
    .summary = "STOPRE stands where radius compensation is in force",
    .why = "With compensation the control looks at the next moves to find where this one ends. STOPRE keeps "
           "it from that: it stops in the contour and waits for the start key, or goes on, as it is set.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .needs = {Capability::paired_words},
    .facts = dataflow::facts<dataflow::BeforeNode>(),
    .data_flow = true,
    .messages = {{"stop",
                  "Stop of reading ahead under compensation: {0} of line {1} is still in force at '{2}'.",
                  "Write {3} into a straight move away from the contour before it, or move it there."}},
    .bad = {{"sinumerik", R"nc(
G17 G90 G54
G0 X-30 Y-30
G41 G1 X0 Y-10 F500
Y60
STOPRE
X80
G40 G0 X100
M30
)nc"}},
    .good = {{"sinumerik", R"nc(
G17 G90 G54
G0 X-30 Y-30
STOPRE
G41 G1 X0 Y-10 F500
Y60
X80
G40 G0 X100
M30
)nc"}},
    .alarms = {{"SINUMERIK", "10778", "preprocessing stop while tool radius compensation is on", false}},
    .sources = {"T: setting data 42480"},
    .check = &check,
};

namespace {

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    const Program& program = analysis.program();
    report_under_compensation(analysis, "stop", reporter, [&](EffectId id) {
        return std::holds_alternative<Synchronise>(program.effects[id].what);
    });
}

} // namespace
} // namespace maclint::rules
