//! Asks for switches, and names them.
#include "rules/words/row_switch.hpp"

#include "analyzer/program/word_condition.hpp"
#include "analyzer/queries/machine/switches_at.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/words/row_text.hpp"

namespace maclint {

std::optional<machine::Switched> switched_as(const queries::WordsOfBlock& block, const WordRow& row) {
    if (row.while_on.empty() && row.while_off.empty()) return machine::Switched{};
    if (row.says == RowStatement::left_on) return machine::Switched{};
    std::optional<machine::Switched> switched = machine::Switched{};
    const auto must_be = [&](std::string_view name, bool on) {
        const auto of = queries::find_switch(block.analysis.control(), name);
        if (!of || !switched) return switched.reset();
        const machine::Switched one = block.switches_at.before(block.block, block.section, *of);
        if (on ? one.is_surely_on() : one.is_surely_off())
            switched = one;
        else
            switched.reset();
    };
    if (!row.while_on.empty()) must_be(row.while_on, true);
    for_each_part(row.while_off, ',', [&](std::string_view name) { must_be(name, false); });
    return switched;
}

std::string_view first_switch_off(const WordRow& row) {
    return row.while_off.view().substr(0, row.while_off.view().find(','));
}

std::string place_without(const WordRow& row) {
    if (!row.while_on.empty()) return "while the " + std::string(row.while_on) + " is on";
    if (!row.while_off.empty()) return "while the " + std::string(first_switch_off(row)) + " is off";
    return row.sections.empty() ? "here" : "in " + sections_in_words(row.sections);
}

std::string switch_condition_of(const WordRow& row) {
    if (row.says == RowStatement::refused || row.says == RowStatement::left_on) return {};
    std::string text;
    if (!row.while_on.empty()) text += "While the " + std::string(row.while_on) + " is on: ";
    if (!row.while_off.empty()) text += "While the " + std::string(first_switch_off(row)) + " is off: ";
    return text;
}

} // namespace maclint
