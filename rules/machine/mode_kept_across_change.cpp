//! MAC531: a shift, a rotation or the like that acts on the next tool or work offset.
#include "rules/fixes.hpp"
#include "rules/machine_check.hpp"
#include "rules/path.hpp"

#include <string>

namespace maclint::rules {

namespace {
void check(const MachineStep& at, Reporter& reporter);
}

extern const Rule mode_kept_across_change{
    .code = "MAC531",
    .name = "mode-kept-across-change",
    .summary =
        "A shift, rotation, scaling or mirror image, or polar coordinates, kept over a change of the tool "
        "or work offset",
    .why = "It was meant for what the tool before had to do, or for the part in the other fixture: the next "
           "positions are shifted or turned by it, and lie elsewhere than they are written.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .messages =
        {{"tool",
          "Still in force: {0}, {1} of line {2}, moves '{3}' elsewhere, behind the tool change of line {4}.",
          "Write {5} before the change, as the program does elsewhere."},
         {"offset",
          "Still in force: {0}, {1} of line {2}, moves '{3}' elsewhere, behind the other work offset of line "
          "{4}.",
          "Write {5} before the next work offset, or give the shift again where it is meant."}},
    .bad = {{"fanuc", R"nc(
O9531(TWO SLOTS)
G90 G17 G54 T1 M6
S3000 M3 G43 H1 Z50.
G68 X0 Y0 R30.
G0 X20. Y0
G1 Z-2. F200.
G0 Z50.
G69
T2 M6
S3000 M3 G43 H2 Z50.
G68 X0 Y0 R30.
G0 X20. Y0
G1 Z-5. F200.
G0 Z50.
T3 M6
S1200 M3 G43 H3 Z50.
G0 X0 Y0
G1 Z-5. F100.
G0 Z50.
G69
M30
)nc"},
            {"fanuc", R"nc(
O9531(TWO FIXTURES)
G90 G17 G54 T1 M6
S3000 M3 G43 H1 Z50.
G52 X120. Y40.
G0 X0 Y0
G1 Z-2. F200.
G0 Z50.
G55 X0 Y0
G1 Z-2. F200.
G0 Z50.
G52 X0 Y0
M30
)nc"}},
    .good = {{"fanuc", R"nc(
O9531(THE WHOLE JOB IS TURNED)
G90 G17 G54
G68 X0 Y0 R30.
T1 M6
S3000 M3 G43 H1 Z50.
G0 X20. Y0
G1 Z-2. F200.
G0 Z50.
T2 M6
S3000 M3 G43 H2 Z50.
G0 X20. Y0
G1 Z-5. F200.
G0 Z50.
G69
M30
)nc"},
             {"fanuc", R"nc(
O9531(ONE SHIFT FOR ALL FIXTURES)
G90 G17 G54 T1 M6
S3000 M3 G43 H1 Z50.
G52 X120. Y40.
G0 X0 Y0
G1 Z-2. F200.
G0 Z50.
G55 X0 Y0
G1 Z-2. F200.
G0 Z50.
G56 X0 Y0
G1 Z-2. F200.
G0 Z50.
G52 X0 Y0
M30
)nc"}},
    .sources = {"T"},
    .check = MachineCheck{&check},
};

namespace {

void check(const MachineStep& at, Reporter& reporter) {
    const auto kept = at.habits.kept_modes().at(at.block().begin);
    if (!kept) return;
    const ControlModel& control = at.analysis.control();
    const GroupId group = *control.group_with(kept->role);
    const ModalGroup& row = control.groups[group];
    const std::string off = row.cancel_words.empty() ? control.spell(group, row.cancel.value_or(0))
                                                     : std::string(row.cancel_words);
    const machine::Known change = machine::Known::of(0, kept->change);
    Finding& finding = reporter.report(at.cause(), at.block(), kept->is_of_tools ? "tool" : "offset",
                                       {std::string(row.name), control.spell(group, kept->mode.value),
                                        at.line_of(kept->mode), at.quoted_block(), at.line_of(change), off});
    offer_block_before(finding, Applicability::unsafe, at.block_of(change), off);
    finding.related.push_back(at.at(kept->mode, "it begins here"));
    finding.related.push_back(
        at.at(change, kept->is_of_tools ? "the tool is changed here" : "the work offset is changed here"));
}

} // namespace
} // namespace maclint::rules
