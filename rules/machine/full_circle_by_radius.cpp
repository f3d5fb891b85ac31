//! MAC558: a full circle by its radius.
#include "analyzer/dataflow/facts/call_begun.hpp"
#include "analyzer/dataflow/facts/point_state.hpp"
#include "analyzer/dataflow/facts/read.hpp"
#include "rules/machine_check.hpp"
#include "rules/path.hpp"

namespace maclint::rules {

namespace {
void check(const MachineStep& at, Reporter& reporter);
}

extern const Rule full_circle_by_radius{
    .code = "MAC558",
    .name = "full-circle-by-radius",
    .summary = "An arc by its radius ends where it begins",
    .why = "Any number of circles go through one point with one radius: the control takes none, and the tool "
           "stands still, or goes straight down where a helix was meant.",
    .severity = Severity::warning,
    .precision = Precision::very_high,
    .facts = dataflow::facts<dataflow::BeforeNode, dataflow::CallBegun, dataflow::Read>(),
    .messages = {{"stands",
                  "Full circle by its radius: '{0}' ends where it begins, and with {1} nothing is cut.",
                  "Write the centre in {2} in place of {1}."}},
    .bad = {{"fanuc", R"nc(
O9558(BOSS)
G17 G90 G21 G0 X30. Y0
G1 Z-5. F200.
G2 X30. Y0 R30.
G0 Z50.
M30
)nc"}},
    .good = {{"fanuc", R"nc(
O9558(BOSS)
G17 G90 G21 G0 X30. Y0
G1 Z-5. F200.
G2 X30. Y0 I-30.
G2 X-30. R30.
G2 X30. R30.
G0 Z50.
M30
)nc"}},
    .sources = {"T: REF"},
    .check = MachineCheck{.check = &check, .with_numbers_of_calls = true},
};

namespace {

void check(const MachineStep& at, Reporter& reporter) {
    const machine::Arc* arc = at.habits.wrong_arc(at.step.block.span.begin);
    if (arc == nullptr || arc->fault != machine::ArcFault::nothing_moves) return;
    const Span radius = at.place_of(arc->letter);
    reporter.report(at.cause(), radius, "stands",
                    {at.quoted_block(), quoted(at.analysis.program(), radius), arc->letters});
}

} // namespace
} // namespace maclint::rules
