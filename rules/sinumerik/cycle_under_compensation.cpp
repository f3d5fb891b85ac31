//! SIN411: a drilling or milling cycle while radius compensation is in force.
#include "analyzer/dataflow/facts/point_state.hpp"
#include "analyzer/queries/calls/brought_cycles.hpp"
#include "rules/rule.hpp"
#include "rules/sinumerik/under_compensation.hpp"

#include <string>
#include <string_view>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule cycle_under_compensation{
    .code = "SIN411",
    .name = "cycle-under-compensation",
    .summary = "A drilling or milling cycle is called while radius compensation is in force",
    .why =
        "Such a cycle makes paths of its own, and stops with an alarm unless G40 is in force when it begins.",
    .severity = Severity::error,
    .precision = Precision::high,
    .needs = {Capability::paired_words},
    .facts = dataflow::facts<dataflow::BeforeNode>(),
    .data_flow = true,
    .messages = {{"cycle", "Cycle under compensation: {0} of line {1} is still in force at '{2}'.",
                  "Write {3} into a straight move away from the contour before it."}},
    .bad = {{"sinumerik", R"nc(
G17 G90 G54
G0 X-30 Y-30
G41 G1 X0 Y-10 F500
Y60
G0 Z50
CYCLE81(50,0,2,-10,)
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
CYCLE81(50,0,2,-10,)
M30
)nc"}},
    .alarms = {{"SINUMERIK", "61815", "cycle: G40 not active at the call"}},
    .sources = {"T: alarm 61815", "SEED-004:242"},
    .check = &check,
};

namespace {

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    report_under_compensation(analysis, "cycle", reporter, [&](EffectId id) {
        const BroughtCycle* cycle = queries::cycle_called(analysis, id);
        return cycle != nullptr && cycle->wants_no_compensation;
    });
}

} // namespace
} // namespace maclint::rules
