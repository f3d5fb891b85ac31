//! MAC510: cutter compensation that is switched on and never used.
#include "analyzer/machine/compensated.hpp"
#include "analyzer/program/tables.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule compensation_without_move{
    .code = "MAC510",
    .name = "compensation-without-move",
    .summary = "Cutter compensation is switched on, and ends before the tool has moved in its plane",
    .why = "A control comes to the compensated path in a move: without one the cut that was meant has none.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .messages =
        {{"none",
          "Compensation without a move: {0} is switched on here, and ends in line {1} before the tool "
          "has moved in its plane.",
          "Give a straight move between, or remove {0}."}},
    .bad = {{"fanuc", R"nc(
O9510(POCKET)
G21 G17 G90 G40 G54 G0 X0 Y0
G43 H1 Z5. S2000 M3
G41 D1
G1 Z-5. F200.
G40
X20.
Y20.
G0 Z50.
M30
)nc"}},
    .good = {{"fanuc", R"nc(
O9510(POCKET)
G21 G17 G90 G40 G54 G0 X0 Y0
G43 H1 Z5. S2000 M3
G1 Z-5. F200.
G41 D1
X20.
Y20.
X0
G0 Z50.
G40
M30
)nc"}},
    .sources = {"SEED-003:12681, 12717", "T"},
    .check = &check,
};

namespace {

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    if (analysis.machine().empty()) return;
    const ControlModel& control = analysis.control();
    const GroupId group = *control.group_with(ModalRole::cutter_compensation);
    for (const auto& [block, code, ended] :
         machine::compensation_without_move(analysis.program(), analysis.machine()))
        reporter
            .report({analysis, block}, block, "none",
                    {control.spell(group, code), line_number(analysis.file(), ended.begin)})
            .related.push_back({analysis.source(), ended, "it ends here"});
}

} // namespace
} // namespace maclint::rules
