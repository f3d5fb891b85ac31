//! Asks what is in force at the change.
#include "rules/machine/change_under_compensation.hpp"

#include "rules/path.hpp"

namespace maclint::rules {

void check_change_under_compensation(const MachineStep& at, Reporter& reporter) {
    if (!at.is_on(at.before(), ModalRole::cutter_compensation)) return;
    const machine::Known& on = at.before().of(ModalRole::cutter_compensation);
    const std::optional<double> off = at.off(ModalRole::cutter_compensation);
    if (!off || at.after().of(ModalRole::cutter_compensation).is(*off) || !at.is_first_of(on)) return;
    reporter
        .report(at.cause(), at.block(), "change",
                {at.quoted_block(), at.spelled(at.before(), ModalRole::cutter_compensation), at.line_of(on),
                 at.analysis.control().spell(
                     *at.analysis.control().group_with(ModalRole::cutter_compensation), *off)})
        .related.push_back(at.at(on, "compensation begins here"));
}

} // namespace maclint::rules
