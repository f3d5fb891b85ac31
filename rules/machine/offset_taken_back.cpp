//! Looks for cuts under offset 0.
#include "rules/machine/offset_taken_back.hpp"

#include "rules/path.hpp"

namespace maclint::rules {
namespace {

/// The block that cuts: this one, or the one before that calls a program which does.
std::optional<Span> block_that_cuts(const MachineStep& at, const machine::Known& offset) {
    const machine::Known& cut = at.before().cut;
    if (cut.is(1) && cut.by_call && cut.block > offset.block) return at.at(cut, {}).span;
    // The first block of a roughing cycle says how deep its passes are.
    const bool is_of_two = at.step.words.has_one_of(at.letters().roughing) && !at.step.words.has('P');
    return at.cuts() && !is_of_two ? std::optional(at.block()) : std::nullopt;
}

} // namespace

void look_for_offset_taken_back(const MachineStep& at, Reporter& reporter) {
    const machine::Known& tool = at.before().tool;
    const machine::Known& offset = at.before().length_offset;
    if (!tool.is_known() || tool.value == 0 || !offset.is(0) || offset.by_call || at.step.changes_tool)
        return;
    const bool have_others =
        at.habits.others_with_offset(tool.value) > 0 && at.habits.have_all_others_offset(tool.value);
    if (!at.habits.cuts_with_offset(tool.value) && !have_others) return;
    const auto block = block_that_cuts(at, offset);
    if (!block || !at.is_first_of(offset)) return;
    reporter
        .report({at.analysis, *block}, *block, "taken_back",
                {quoted(at.analysis.program(), *block), number_word(tool.value), at.line_of(offset)})
        .related.push_back(at.at(offset, "its offset is 0 from here on"));
}

} // namespace maclint::rules
