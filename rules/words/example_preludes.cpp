//! Looks for the codes that switch.
#include "rules/words/example_preludes.hpp"

#include "analyzer/program/tables.hpp"
#include "analyzer/program/word_condition.hpp"
#include "rules/words/row_switch.hpp"
#include "rules/words/row_text.hpp"
#include "rules/words/word_list.hpp"

#include <algorithm>
#include <string_view>
#include <vector>

namespace maclint {
namespace {

const Switch& switch_named(const ControlModel& control, std::string_view name) {
    return *std::ranges::find(control.switches, name, &Switch::name);
}

/// The first of the codes, without what must stand beside it.
std::string first_code(std::string_view codes) {
    const std::string_view first = codes.substr(0, codes.find(','));
    return std::string(first.substr(0, first.find(' ')));
}

/// A block with the first of the codes, and what must stand beside it.
std::string block_of(const ExamplePlace& place, std::string_view codes) {
    const std::string code = first_code(codes);
    if (code.size() == 1) return code + "1\n"; // any number of the letter
    const std::string_view first = codes.substr(0, codes.find(','));
    const std::string when(first.substr(std::min(code.size() + 1, first.size())));
    const WordRow row{.says = RowStatement::refused,
                      .code = {},
                      .when = when,
                      .effect = {},
                      .severity = Severity::note,
                      .source = {}};
    return ExampleBlock(place.control, code, place.section).text_that_keeps(row) + "\n";
}

/// Whether the block has the words that conditions like "H=1" want, and none that "-NS" excludes.
bool may_hold(std::string_view block, std::string_view conditions) {
    return std::ranges::all_of(words_of(conditions), [&](std::string_view text) {
        const WordCondition condition = condition_of(text);
        const bool stands = block.find(" " + std::string(condition.address)) != std::string_view::npos;
        return condition.there ? stands || condition.or_missing : !stands;
    });
}

} // namespace

void Preludes::switch_on(std::string_view name, SwitchedAround& around) {
    if (std::ranges::find(begun_, name) != begun_.end()) return;
    begun_.push_back(name);
    const std::string_view codes = switch_named(place_.control, name).on;
    const std::string on = block_of(place_, codes);
    if (around.before.find(on) != std::string::npos) return;
    const std::string code = first_code(codes);
    if (code.size() > 1) {
        const ExampleBlock block(place_.control, code, place_.section);
        want(block, nullptr, around);
        around.after += switched_off(block, nullptr, on);
    }
    around.before += on;
}

void Preludes::want(const ExampleBlock& block, const WordRow* but, SwitchedAround& around) {
    for (const WordRow* row : block.rows())
        if (row->says == RowStatement::refused && !row->while_off.empty() && row != but)
            switch_on(first_switch_off(*row), around);
}

void Preludes::leave_reset(const ExampleBlock& block, const WordRow* but, SwitchedAround& around) const {
    for (const WordRow* row : block.rows()) {
        if (row->says != RowStatement::refused || row->under.empty() || row == but) continue;
        const std::string_view code = first_of(row->under);
        const auto id = place_.control.group_of(code.front(), code_number_of(code));
        if (!id) continue;
        const ModalGroup& group = place_.control.groups[*id];
        if (!group.reset || !has_word(row->under, place_.control.spell(*id, *group.reset))) continue;
        for (const ModalMember& member : group.members)
            if (const std::string other = place_.control.spell(*id, member.number);
                !has_word(row->under, other)) {
                around.before = other + "\n" + around.before;
                break;
            }
    }
}

void Preludes::begin_contour(const ExampleBlock& block, const WordRow* but, SwitchedAround& around) const {
    for (const WordRow* row : block.rows())
        if (row->says == RowStatement::refused && !row->unless_after.empty() && row != but) {
            around.before +=
                ExampleBlock(place_.control, first_of(row->unless_after), place_.section).text() + "\n";
            return;
        }
}

std::string Preludes::switched_off(const ExampleBlock& block, const WordRow* but,
                                   std::string_view written) const {
    std::string text;
    for (const WordRow* row : block.rows())
        if (row->says == RowStatement::left_on && row != but && may_hold(written, row->when))
            text += block_of(place_, switch_named(place_.control, row->while_on).off);
    return text;
}

} // namespace maclint
