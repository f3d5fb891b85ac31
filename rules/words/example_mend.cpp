//! Puts words beside a code until every row of it is kept.
#include "rules/words/example_block.hpp"
#include "rules/words/row_condition.hpp"
#include "rules/words/word_list.hpp"

#include <algorithm>

namespace maclint {
namespace {

/// Words that a block that breaks the row must not have.
std::string_view avoided_by(const WordRow& row) {
    if (row.says == RowStatement::needs) return row.words;
    return row.says == RowStatement::only_with ? row.others : std::string_view();
}

} // namespace

/// The words that the row is about, then those that other rows want beside them.
ExampleWords ExampleBlock::words(const WordRow* about, bool kept) const {
    ExampleWords all;
    if (about != nullptr) begin_with(all, *about, kept);
    const std::string_view avoided = about == nullptr || kept ? std::string_view() : avoided_by(*about);
    bool is_mended = true;
    for (int rounds = 0; is_mended && rounds < 20; ++rounds) {
        is_mended = false;
        for (const WordRow* row : rows_)
            if ((row != about || kept) && all.holds(row->when)) is_mended |= mend(all, *row, avoided);
    }
    return all;
}

void ExampleBlock::begin_with(ExampleWords& words, const WordRow& row, bool kept) const {
    for (const std::string_view text : words_of(row.when)) {
        const WordCondition condition = condition_of(text);
        if (!condition.there || condition.or_missing) continue;
        const std::string_view value = fitting_value(condition);
        words.add(condition.address, value.empty() ? value_of(condition.address) : std::string(value));
    }
    const auto add_first = [&](std::string_view list) {
        if (!words.stands(first_of(list))) add(words, first_of(list));
    };
    switch (row.says) {
    case RowStatement::needs:
        if (kept) add_first(row.words);
        break;
    case RowStatement::takes_not:
        if (!kept) add_first(row.words);
        break;
    case RowStatement::takes_only:
        if (!kept) words.add(foreign_word(), "1");
        break;
    case RowStatement::excludes:
        add_first(row.words);
        if (!kept) add_first(row.others);
        break;
    case RowStatement::only_with: add_first(row.words); break;
    case RowStatement::values:
        words.add(first_of(row.words), kept ? allowed_value(row) : refused_value(row));
        break;
    case RowStatement::whole:
        words.add(first_of(row.words), value_of(first_of(row.words)) + (kept ? "" : "."));
        break;
    case RowStatement::at_most: {
        const auto all = words_of(row.words);
        const auto count = static_cast<std::size_t>(row.most) + (kept ? 0 : 1);
        for (std::size_t i = 0; i < count; ++i) add(words, all[i]);
        break;
    }
    case RowStatement::encloses:
    case RowStatement::names_none:
        for (const std::string_view address : words_of(row.words)) add(words, address);
        break;
    case RowStatement::digits:
        words.add(first_of(row.words), kept ? value_of(first_of(row.words)) : "123456789012");
        break;
    case RowStatement::alone:
        if (!kept) words.add("S", "500");
        break;
    case RowStatement::until:
    case RowStatement::apart:
    case RowStatement::precedes:
    case RowStatement::refused:
    case RowStatement::left_on: break;
    }
}

/// Puts in what the row lacks; false: nothing, or there is nothing to put in.
bool ExampleBlock::mend(ExampleWords& words, const WordRow& row, std::string_view avoided) const {
    if (row.says == RowStatement::needs && !words.stands(row.words)) {
        for (const std::string_view address : words_of(row.words)) {
            if (has_word(avoided, address) || forbids(words, address)) continue;
            add(words, address);
            return true;
        }
    }
    if (row.says == RowStatement::only_with && words.stands(row.words)) {
        const auto partners = words_of(row.others);
        const bool has_one =
            std::ranges::any_of(partners, [&](std::string_view partner) { return words.holds(partner); });
        if (has_one) return false;
        const WordCondition partner = condition_of(partners.front());
        const std::string value(partner.values.empty() ? value_of(partner.address)
                                                       : partner.values.substr(0, partner.values.find('|')));
        words.set(partner.address, value);
        return true;
    }
    if (row.says == RowStatement::values)
        for (const auto& [address, value] : words)
            if (has_word(row.words, address) && !takes_written(row, value) && !row.when.empty()) {
                words.set(std::string(address), allowed_value(row) + (value.ends_with('.') ? "." : ""));
                return true;
            }
    return false;
}

bool ExampleBlock::forbids(const ExampleWords& words, std::string_view address) const {
    return std::ranges::any_of(rows_, [&](const WordRow* row) {
        if (row->says == RowStatement::takes_not)
            return row->after.empty() && has_word(row->words, address) && words.holds(row->when);
        return row->says == RowStatement::excludes &&
               ((has_word(row->words, address) && words.stands(row->others)) ||
                (has_word(row->others, address) && words.stands(row->words)));
    });
}

} // namespace maclint
