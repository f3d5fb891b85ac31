//! Puts blocks around an example's.
#include "rules/words/example_switches.hpp"

#include "analyzer/program/tables.hpp"
#include "rules/words/example_preludes.hpp"
#include "rules/words/row_text.hpp"
#include "rules/words/word_list.hpp"

#include <algorithm>
#include <string_view>

namespace maclint {

SwitchedAround switched_around(const RowForCode& row, const ExampleBlock& block, const ExamplePlace& place,
                               bool kept) {
    const WordRow* broken = kept ? nullptr : row.row;
    const std::string written = kept ? block.text_that_keeps(*row.row) : block.text(row.row);
    SwitchedAround around;
    Preludes preludes(place);
    if (!row.row->while_off.empty()) preludes.want(block, broken, around);
    const bool wants_on = row.row->says == RowStatement::refused ? !kept : true;
    if (!row.row->while_on.empty() && row.row->says != RowStatement::left_on && wants_on)
        preludes.switch_on(row.row->while_on, around);
    preludes.leave_reset(block, broken, around);
    preludes.begin_contour(block, broken, around);
    around.after = preludes.switched_off(block, broken, written) + around.after;
    if (written == code_of(row) && around.after == written + "\n")
        around.after.clear(); // the block ends it itself
    return around;
}

std::string switched_under(const WordRow& row, const ExamplePlace& place, std::string& after) {
    const std::string code(first_of(row.under));
    if (place.frame.main_section.empty())
        return code + (row.says == RowStatement::refused ? std::string(place.frame.straight) : "") + "\n";
    const ExampleBlock block(place.control, code, place.section);
    std::string text = block.text() + "\n";
    if (const WordRow* order = block.order(); order != nullptr)
        text += ExampleBlock(place.control, first_of(order->others), place.section).text() + "\n";
    if (const auto group = place.control.group_of(code.front(), code_number_of(code)))
        if (const std::string_view off = place.control.groups[*group].cancel_words; !off.empty())
            after += std::string(off) + "\n";
    return text;
}

} // namespace maclint
