//! MAC524: increments of a reference position return that the next move takes for its own.
#include "rules/fixes.hpp"
#include "rules/machine_check.hpp"
#include "rules/path.hpp"

#include <algorithm>

namespace maclint::rules {

namespace {
void check(const MachineStep& at, Reporter& reporter);
}

extern const Rule incremental_after_reference{
    .code = "MAC524",
    .name = "incremental-after-reference",
    .summary = "The G91 of a reference position return is still in force at the next position",
    .why = "The tool moves by the numbers, and not to them: from the reference position into whatever stands "
           "there.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .messages =
        {{"kept",
          "Increments kept: '{0}' moves by its numbers, because the {1} of line {2} is still in force.",
          "Write G90 before it, or in this block."},
         {"added",
          "Increments kept: '{0}' adds its numbers to the offset, because the {1} of line {2} is still in "
          "force.",
          "Write G90 before it, or in this block."}},
    .bad = {{"fanuc", R"nc(
O9524(PLATE)
G90 G17 G54
T1 M6
S3000 M3
G0 X0 Y0
G43 H1 Z5.
G1 Z-5. F200.
G0 Z50.
G91 G28 Z0
T2 M6
S1200 M3
G0 X25. Y25.
G43 H2 Z5.
G1 Z-5. F200.
M30
)nc"}},
    .good = {{"fanuc", R"nc(
O9524(PLATE)
G90 G17 G54
T1 M6
S3000 M3
G0 X0 Y0
G43 H1 Z5.
G1 Z-5. F200.
G0 Z50.
G91 G28 Z0
G28 X0 Y0
T2 M6
S1200 M3
G90 G0 X25. Y25.
G43 H2 Z5.
G1 Z-5. F200.
M30
)nc"},
             {"fanuc", R"nc(
O9524(THE TABLE COMES FORWARD)
G90 G17 G54
T1 M6
S3000 M3
G0 X0 Y0
G43 H1 Z5.
G1 Z-5. F200.
G91 G28 Z0
G0 Y200.
M30
)nc"}},
    .sources = {"T"},
    .check = MachineCheck{&check},
};

namespace {

/// A block that sets a work offset: the axes have values in it.
bool sets_offset(const MachineStep& at) {
    return at.step.words.has_one_of(at.letters().settings) &&
           std::ranges::any_of(at.letters().axes, [&](char letter) { return at.step.words.has(letter); });
}

/// Whether the block moves by a number that is not 0, where nobody goes on by increments: after a tool
/// change, or in a cut. Without a change the table may be brought to the operator.
bool moves_by_numbers(const MachineStep& at, const machine::Known& distance) {
    using machine::Move;
    const bool goes_somewhere = at.step.move == Move::rapid || at.cuts();
    const machine::Known& changed = at.after().changed;
    const bool is_new_tool = changed.is_known() && changed.block > distance.block;
    return goes_somewhere && (is_new_tool || at.cuts()) &&
           std::ranges::any_of(at.letters().axes, [&](char letter) {
               const auto number = at.step.words.number(letter);
               return number && number->value != 0;
           });
}

void check(const MachineStep& at, Reporter& reporter) {
    if (!at.after().distance_for_return.is(1)) return;
    if (machine::sets(at.analysis.control(), at.step.block, ModalRole::distance)) return;
    const machine::Known& distance = at.after().of(ModalRole::distance);
    if (!distance.is_known() || distance.is(at.letters().absolute)) return;
    const bool adds = sets_offset(at);
    if ((!adds && !moves_by_numbers(at, distance)) || !at.is_first_of(at.after().distance_for_return)) return;
    Finding& finding = reporter.report(at.cause(), at.block(), adds ? "added" : "kept",
                                       {at.quoted_block(), at.spelled(at.after(), ModalRole::distance),
                                        at.line_of(at.after().distance_for_return)});
    finding.related.push_back(at.at(at.after().distance_for_return, "it stands here, for the return"));
    const auto group = at.analysis.control().group_with(ModalRole::distance);
    offer_block_before(finding, Applicability::unsafe, at.block(),
                       at.analysis.control().spell(*group, at.letters().absolute));
}

} // namespace
} // namespace maclint::rules
