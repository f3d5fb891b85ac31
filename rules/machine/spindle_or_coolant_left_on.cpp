//! MAC563: a spindle or coolant that one tool change of a program finds running, and all others do not.
#include "rules/fixes.hpp"
#include "rules/machine_check.hpp"
#include "rules/path.hpp"

namespace maclint::rules {

namespace {
void check(const MachineStep& at, Reporter& reporter);
}

extern const Rule spindle_or_coolant_left_on{
    .code = "MAC563",
    .name = "spindle-or-coolant-left-on",
    .summary =
        "The spindle or the coolant still runs at a tool change, and is switched off before all others",
    .why =
        "A block is missing that the program writes for each other tool. Most machines stop the spindle for "
        "the change themselves; where one does not, the arm takes a turning tool, or coolant runs into the "
        "magazine.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .messages =
        {{"spindle",
          "Still running: '{0}' changes the tool under the {1} of line {2}, and each other tool stops first.",
          "Write {3} before the change."},
         {"coolant",
          "Still on: '{0}' changes the tool under the {1} of line {2}, and coolant is off at each other "
          "change.",
          "Write {3} before the change."}},
    .bad = {{"fanuc", R"nc(
O9563(PLATE)
G90 G17 G54
T1 M6
S3000 M3
G43 H1 Z50. M8
G1 Z-5. F200.
G0 Z50. M9
M5
T2 M6
S2000 M3
G43 H2 Z50. M8
G1 Z-8. F200.
G0 Z50. M9
M5
T3 M6
S1000 M3
G43 H3 Z50. M8
G1 Z-9. F200.
G0 Z50. M9
T4 M6
S1500 M3
G43 H4 Z50. M8
G1 Z-9. F200.
G0 Z50. M9
M5
M30
)nc"}},
    .good = {{"fanuc", R"nc(
O9563(THE MACHINE STOPS ITS SPINDLE)
G90 G17 G54
T1 M6
S3000 M3
G43 H1 Z50.
G1 Z-5. F200.
G0 Z50.
T2 M6
S2000 M3
G43 H2 Z50.
G1 Z-8. F200.
G0 Z50. M5
T3 M6
S1000 M3
G43 H3 Z50.
G1 Z-9. F200.
G0 Z50.
T4 M6
S1500 M3
G43 H4 Z50.
G1 Z-9. F200.
G0 Z50. M5
M30
)nc"}},
    .sources = {"T"},
    .check = MachineCheck{&check},
};

namespace {

void check(const MachineStep& at, Reporter& reporter) {
    const ControlModel& control = at.analysis.control();
    // A turret turns beside a spindle that runs.
    if (!at.step.changes_tool || !at.before().cut.is(1) || at.letters().tool_word_holds_offset) return;
    const machine::Known& spindle = at.before().of(ModalRole::spindle);
    if (at.habits.spindle_at_changes().is_off_at_all_but_one() &&
        machine::spindle_runs_into(at.step, control)) {
        const auto group = *control.group_with(ModalRole::spindle);
        const std::string off = control.spell(group, *at.off(ModalRole::spindle));
        Finding& finding = reporter.report(
            at.cause(), at.block(), "spindle",
            {at.quoted_block(), at.spelled(at.before(), ModalRole::spindle), at.line_of(spindle), off});
        finding.related.push_back(at.at(spindle, "it is started here"));
        offer_block_before(finding, Applicability::unsafe, at.block(), off);
    } else if (at.habits.coolant_at_changes().is_off_at_all_but_one() &&
               machine::coolant_runs_into(at.step, control)) {
        const machine::Known& coolant = at.before().coolant;
        const std::string off = "M" + number_word(at.letters().coolant_off);
        Finding& finding =
            reporter.report(at.cause(), at.block(), "coolant",
                            {at.quoted_block(), "M" + number_word(coolant.value), at.line_of(coolant), off});
        finding.related.push_back(at.at(coolant, "it is switched on here"));
        offer_block_before(finding, Applicability::unsafe, at.block(), off);
    }
}

} // namespace
} // namespace maclint::rules
