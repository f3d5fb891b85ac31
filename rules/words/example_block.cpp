//! Finds the rows of a code, and writes its block.
#include "rules/words/example_block.hpp"

#include "rules/words/book_language.hpp"
#include "rules/words/example_frames.hpp"
#include "rules/words/row_place.hpp"
#include "rules/words/word_list.hpp"

#include <algorithm>

namespace maclint {

std::string_view first_of(std::string_view list) { return words_of(list).front(); }

ExampleBlock::ExampleBlock(const ControlModel& control, std::string_view code, std::string_view section)
    : control_(control)
    , code_(code) {
    for (const RuleRow& rule_row : all_rule_rows())
        for (const RowForCode& row : rule_row.rows) {
            if (row.letter != code.front() || row.code != code_number_of(code) || !is_of(row, control))
                continue;
            const std::string_view sections =
                row.row->sections.empty() ? row.table->sections : row.row->sections;
            if (sections.empty() || section.empty() || has_word(sections, section)) rows_.push_back(row.row);
        }
}

std::string ExampleBlock::text(const WordRow* broken) const { return written(words(broken, false)); }

std::string ExampleBlock::text_that_keeps(const WordRow& row) const { return written(words(&row, true)); }

const WordRow* ExampleBlock::order(const WordRow* broken) const {
    const ExampleWords all = words(broken, broken == nullptr);
    const auto found = std::ranges::find_if(rows_, [&](const WordRow* row) {
        return row->says == RowStatement::precedes && !row->others.empty() && all.holds(row->when);
    });
    return found == rows_.end() ? nullptr : *found;
}

const WordRow* ExampleBlock::enclosed() const {
    const auto found = std::ranges::find(rows_, RowStatement::encloses, &WordRow::says);
    return found == rows_.end() ? nullptr : *found;
}

const WordRow* ExampleBlock::begun_data(const WordRow* broken) const {
    const ExampleWords all = words(broken, broken == nullptr);
    const auto found = std::ranges::find_if(
        rows_, [&](const WordRow* row) { return row->says == RowStatement::until && all.holds(row->when); });
    return found == rows_.end() ? nullptr : *found;
}

void ExampleBlock::add(ExampleWords& words, std::string_view address) const {
    words.add(address, value_of(address));
}

/// A value that every row allows.
std::string ExampleBlock::value_of(std::string_view address) const {
    for (const WordRow* row : rows_)
        if (row->says == RowStatement::values && row->when.empty() && has_word(row->words, address))
            return allowed_value(*row);
    for (const WordRow* row : rows_)
        if (row->says == RowStatement::names_none && has_word(row->words, address)) return "10";
    if (const WordRow* row = enclosed(); row != nullptr && has_word(row->words, address))
        return words_of(row->words).front() == address ? "10" : "20";
    return has_word(frame_of(control_).with_point, address) ? "10." : "2";
}

/// An address that the code does not take, and no move that goes on.
std::string ExampleBlock::foreign_word() const {
    for (const WordRow* row : rows_)
        if (row->says == RowStatement::takes_only)
            return std::string(first_of(foreign_words(control_.language, row->words)));
    return std::string(words_of(book_language(control_.language).of_codes).back());
}

std::string ExampleBlock::written(const ExampleWords& words) const {
    std::string text = code_;
    for (const auto& [address, value] : words) text.append(" ").append(address).append(value);
    return text;
}

} // namespace maclint
