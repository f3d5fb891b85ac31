//! MAC513: blocks without a move between two moves of a compensated path.
#include "analyzer/machine/compensated.hpp"
#include "analyzer/program/tables.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"

#include <string>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule no_move_blocks_in_compensation{
    .code = "MAC513",
    .name = "no-move-blocks-in-compensation",
    .summary = "Blocks without a move in the plane stand between two moves under cutter compensation",
    .why = "The control looks few blocks ahead for the next corner. Where it finds no move there, it goes to "
           "the "
           "end of the last one as if the path ended, and cuts into the next side.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .messages = {{"blocks",
                  "Blocks without a move in compensation: lines {0} to {1} do not move in the plane of {2}, "
                  "and the control does not see the corner behind them.",
                  "Put their words into blocks that move, or write them before {2}."}},
    .bad = {{"fanuc", R"nc(
O9513(OUTLINE)
G21 G17 G90 G40 G54 G0 X-20. Y-20.
G43 H1 Z5. S2000 M3
G1 Z-5. F200.
G41 D1 X0
Y40.
M8
G4 P500
Z-6.
X60.
G40 Y-20.
G0 Z50.
M30
)nc"}},
    .good = {{"fanuc", R"nc(
O9513(OUTLINE)
G21 G17 G90 G40 G54 G0 X-20. Y-20.
G43 H1 Z5. S2000 M3
G41 D1
M8
G1 Z-5. F200.
X0
Y40.
M9
X60.
M5
G0 Z50.
G40 Y-20.
M30
)nc"}},
    .sources = {"T: alarm 041"},
    .check = &check,
};

namespace {

/// So many blocks without a move are too many for any control that reads ahead three; the lists of alarms
/// tell older ones, which read two.
std::size_t too_many(const ControlModel& control) {
    constexpr std::size_t of_older = 2, of_newer = 3;
    return control.alarms.starts_with("FANUC 16i") && !control.assumed ? of_older : of_newer;
}

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    const ControlModel& control = analysis.control();
    if (analysis.machine().empty() || control.alarms.empty()) return;
    const GroupId group = *control.group_with(ModalRole::cutter_compensation);
    for (const machine::StandingBlocks& blocks :
         machine::standing_blocks(analysis.program(), analysis.machine())) {
        if (blocks.count < too_many(control)) continue;
        reporter
            .report({analysis, blocks.last}, blocks.last, "blocks",
                    {line_number(analysis.file(), blocks.first.begin),
                     line_number(analysis.file(), blocks.last.begin), control.spell(group, blocks.code)})
            .related.push_back({analysis.source(), blocks.next, "the next move"});
    }
}

} // namespace
} // namespace maclint::rules
