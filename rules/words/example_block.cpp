//! Puts words beside a code until every row of it is kept.
#include "rules/words/example_block.hpp"

#include "rules/path.hpp"
#include "rules/words/example_frames.hpp"
#include "rules/words/row_condition.hpp"
#include "rules/words/row_of_block.hpp"
#include "rules/words/word_list.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace maclint {
namespace {

using Words = std::vector<std::pair<std::string, std::string>>;

auto find(Words& words, std::string_view address) {
    return std::ranges::find(words, address, &Words::value_type::first);
}
bool stands(const Words& words, std::string_view list) {
    return std::ranges::any_of(words, [&](const auto& word) { return has_word(list, word.first); });
}

bool has_value(const std::string& written, std::string_view values) {
    std::string list(values);
    std::ranges::replace(list, '|', ' ');
    return values.empty() || has_word(list, written);
}

bool holds(const Words& words, std::string_view conditions) {
    return std::ranges::all_of(words_of(conditions), [&](std::string_view text) {
        const RowCondition condition = condition_of(text);
        const auto word = std::ranges::find(words, condition.address, &Words::value_type::first);
        if (word == words.end()) return !condition.there || condition.or_missing;
        return condition.there && has_value(word->second, condition.values) != condition.others;
    });
}

bool allows(const WordRow& row, const std::string& written) {
    if (!row.values.empty()) return has_word(row.values, written);
    double value = 0;
    std::from_chars(written.data(), written.data() + written.size(), value);
    return (row.above_least ? value > row.least : value >= row.least) &&
           (row.below_most ? value < row.most : value <= row.most);
}

std::string allowed_value(const WordRow& row) {
    if (!row.values.empty()) return std::string(first_of(row.values));
    if (!std::isfinite(row.most)) return number_word(row.above_least ? row.least + 1 : row.least);
    return number_word(std::isfinite(row.least) ? (row.least + row.most) / 2 : row.most - 1);
}

std::string refused_value(const WordRow& row) {
    if (!row.values.empty()) return "99999";
    return number_word(std::isfinite(row.most) ? row.most + 1 : row.least - 1);
}

/// Words that a block that breaks the row must not have.
std::string_view avoided_by(const WordRow& row) {
    if (row.says == RowStatement::needs) return row.words;
    return row.says == RowStatement::only_with ? row.others : std::string_view();
}

} // namespace

std::string_view first_of(std::string_view list) { return words_of(list).front(); }

ExampleBlock::ExampleBlock(const WordTable& table, std::string_view control, std::string_view code,
                           std::string_view section)
    : language_(table.language)
    , code_(code) {
    for (const RuleRow& rule_row : all_rule_rows())
        for (const RowForCode& row : rule_row.rows) {
            if (row.table->language != language_ || row.letter != code.front() ||
                row.code != code_number_of(code))
                continue;
            const std::string_view sections =
                row.row->sections.empty() ? row.table->sections : row.row->sections;
            const bool there = sections.empty() || section.empty() || has_word(sections, section);
            const bool of_control =
                row.row->controls.empty() || control.empty() || has_word(row.row->controls, control);
            if (there && of_control) rows_.push_back(row.row);
        }
}

std::string ExampleBlock::text(const WordRow* broken) const { return written(words(broken, false)); }

std::string ExampleBlock::text_that_keeps(const WordRow& row) const { return written(words(&row, true)); }

const WordRow* ExampleBlock::order(const WordRow* broken) const {
    const Words all = words(broken, broken == nullptr);
    const auto found = std::ranges::find_if(rows_, [&](const WordRow* row) {
        return row->says == RowStatement::precedes && !row->others.empty() && holds(all, row->when);
    });
    return found == rows_.end() ? nullptr : *found;
}

/// The words that the row is about, then those that other rows want beside them.
Words ExampleBlock::words(const WordRow* about, bool kept) const {
    Words all;
    if (about != nullptr) begin_with(all, *about, kept);
    const std::string_view avoided = about == nullptr || kept ? std::string_view() : avoided_by(*about);
    bool is_mended = true;
    for (int rounds = 0; is_mended && rounds < 20; ++rounds) {
        is_mended = false;
        for (const WordRow* row : rows_)
            if ((row != about || kept) && holds(all, row->when)) is_mended |= mend(all, *row, avoided);
    }
    return all;
}

void ExampleBlock::begin_with(Words& words, const WordRow& row, bool kept) const {
    for (const std::string_view text : words_of(row.when)) {
        const RowCondition condition = condition_of(text);
        if (!condition.there || condition.or_missing) continue;
        const std::string_view value =
            condition.others ? std::string_view() : condition.values.substr(0, condition.values.find('|'));
        words.emplace_back(condition.address, value.empty() ? value_of(condition.address) : value);
    }
    const auto add_first = [&](std::string_view list) {
        if (!stands(words, first_of(list))) add(words, first_of(list));
    };
    switch (row.says) {
    case RowStatement::needs:
        if (kept) add_first(row.words);
        break;
    case RowStatement::takes_not:
        if (!kept) add_first(row.words);
        break;
    case RowStatement::takes_only:
        if (!kept) words.emplace_back(foreign_word(), "1");
        break;
    case RowStatement::excludes:
        add_first(row.words);
        if (!kept) add_first(row.others);
        break;
    case RowStatement::only_with: add_first(row.words); break;
    case RowStatement::values:
        words.emplace_back(first_of(row.words), kept ? allowed_value(row) : refused_value(row));
        break;
    case RowStatement::whole:
        words.emplace_back(first_of(row.words), value_of(first_of(row.words)) + (kept ? "" : "."));
        break;
    case RowStatement::alone:
        if (!kept) words.emplace_back("S", "500");
        break;
    case RowStatement::apart:
    case RowStatement::precedes:
    case RowStatement::refused: break;
    }
}

/// Puts in what the row lacks; false: nothing, or there is nothing to put in.
bool ExampleBlock::mend(Words& words, const WordRow& row, std::string_view avoided) const {
    if (row.says == RowStatement::needs && !stands(words, row.words)) {
        for (const std::string_view address : words_of(row.words)) {
            if (has_word(avoided, address) || forbids(words, address)) continue;
            add(words, address);
            return true;
        }
    }
    if (row.says == RowStatement::only_with && stands(words, row.words)) {
        const auto partners = words_of(row.others);
        const bool has_one =
            std::ranges::any_of(partners, [&](std::string_view partner) { return holds(words, partner); });
        if (has_one) return false;
        const RowCondition partner = condition_of(partners.front());
        const std::string value(partner.values.empty() ? value_of(partner.address)
                                                       : partner.values.substr(0, partner.values.find('|')));
        const auto there = find(words, partner.address);
        if (there == words.end())
            words.emplace_back(partner.address, value);
        else
            there->second = value;
        return true;
    }
    if (row.says == RowStatement::values)
        for (auto& [address, value] : words)
            if (has_word(row.words, address) && !allows(row, value) && !row.when.empty()) {
                value = allowed_value(row);
                return true;
            }
    return false;
}

bool ExampleBlock::forbids(const Words& words, std::string_view address) const {
    return std::ranges::any_of(rows_, [&](const WordRow* row) {
        if (row->says == RowStatement::takes_not)
            return row->after.empty() && has_word(row->words, address) && holds(words, row->when);
        return row->says == RowStatement::excludes &&
               ((has_word(row->words, address) && stands(words, row->others)) ||
                (has_word(row->others, address) && stands(words, row->words)));
    });
}

void ExampleBlock::add(Words& words, std::string_view address) const {
    words.emplace_back(address, value_of(address));
}

/// A value that every row allows.
std::string ExampleBlock::value_of(std::string_view address) const {
    for (const WordRow* row : rows_)
        if (row->says == RowStatement::values && row->when.empty() && has_word(row->words, address))
            return allowed_value(*row);
    return has_word(frame_of(language_).with_point, address) ? "10." : "2";
}

/// An address that the code does not take.
std::string ExampleBlock::foreign_word() const {
    for (const WordRow* row : rows_)
        if (row->says == RowStatement::takes_only)
            for (const char letter : std::string_view("QHVWDBEJKUROPXZCAIYL"))
                if (!has_word(row->words, std::string_view(&letter, 1))) return {letter};
    return "L";
}

std::string ExampleBlock::written(const Words& words) const {
    std::string text = code_;
    for (const auto& [address, value] : words) text.append(" ").append(address).append(value);
    return text;
}

} // namespace maclint
