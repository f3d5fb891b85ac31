//! Writes what a row says.
#include "rules/words/row_text.hpp"

#include "rules/path.hpp"
#include "rules/words/row_condition.hpp"
#include "rules/words/row_switch.hpp"
#include "rules/words/usual_effect.hpp"
#include "rules/words/word_list.hpp"

#include <algorithm>
#include <cmath>

namespace maclint {
namespace {

/// Of an address, whatever codes stand beside it.
std::string address_in_words(const WordRow& row) {
    const std::string words = words_with_meaning(row);
    if (row.says == RowStatement::whole) return words + " has no decimal point; with one ";
    if (row.says == RowStatement::digits)
        return words + " has " + number_word(row.most) + " digits before its point at most; with more ";
    return words + " is " + values_allowed_by(row) + "; else ";
}

std::string rule_in_words(const RowForCode& of_code) {
    if (of_code.is_of_address()) return address_in_words(*of_code.row);
    const WordRow& row = *of_code.row;
    const std::string code = code_of(of_code);
    const std::string words = words_with_meaning(row);
    switch (row.says) {
    case RowStatement::needs: return code + " needs " + words + "; without it ";
    case RowStatement::takes_only:
        return code + " takes no words" + (row.words.empty() ? ": " : " but " + all_of(row.words) + ": ");
    case RowStatement::apart: return code + " does not stand beside " + either_of(row.others) + ": ";
    case RowStatement::takes_not: return code + " does not take " + words + ": ";
    case RowStatement::excludes:
        return code + " takes " + words + " or " + either_of(row.others) + ", not both: ";
    case RowStatement::only_with:
        return words + " of " + code + " counts beside " + partners_of(row) + " only: ";
    case RowStatement::values:
        return code + " takes " + words + " of " + values_allowed_by(row) +
               (row.effect == no_other_value ? ": " : "; else ");
    case RowStatement::whole: return words + " of " + code + " has no decimal point; with one ";
    case RowStatement::at_most:
        return code + " takes " + number_word(row.most) + " of " + all_of(row.words) + " at most: ";
    case RowStatement::until:
        return "From " + code + " to " + either_of(row.others) + " stand " + all_of(row.words) + " only: ";
    case RowStatement::encloses:
        return all_of(row.words) + " of " + code +
               " number the first and the last block of a part of the program" +
               (row.first_block.empty() ? "" : ", which begins with " + either_of(row.first_block)) +
               (row.others.empty() ? "" : " and holds no " + either_of(row.others)) + "; else ";
    case RowStatement::digits:
        return words + " of " + code + " has " + number_word(row.most) +
               " digits before its point at most; with more ";
    case RowStatement::alone:
        return code + " stands alone in its block" +
               (row.words.empty() ? ": " : ", beside " + either_of(row.words) + " at most: ");
    case RowStatement::precedes:
        return "The block after " + code + " holds " +
               (row.others.empty() ? "another code than " + either_of(row.words) : either_of(row.others)) +
               ": ";
    case RowStatement::refused: return code + " has no place " + place_without(row) + ": ";
    case RowStatement::names_none:
        return words + " of " + code + " numbers a block with " + either_of(row.first_block) + ", not with " +
               either_of(row.others) + ": ";
    case RowStatement::left_on:
        return code + " switches on the " + std::string(row.while_on) + ", which is off again " +
               (row.others.empty() ? "" : "at the next T and ") + "when the program ends: ";
    }
    return {};
}

/// "Under G41 or G42, " in front of what holds only there.
std::string condition_of(const WordRow& row) {
    std::string text = row.under.empty() ? "" : "Under " + either_of(row.under) + ": ";
    text += switch_condition_of(row);
    if (!row.when.empty()) text += conditions_in_words(row.when) + ": ";
    if (!row.after.empty()) text += "After " + either_of(row.after) + ": ";
    if (!row.unless_next.empty())
        text += "Unless a block with " + std::string(words_of(row.unless_next).front()) +
                " or the like follows: ";
    return text;
}

} // namespace

std::string words_with_meaning(const WordRow& row) {
    const std::string words = either_of(row.words);
    return row.means.empty() ? words : words + " (" + std::string(row.means) + ")";
}

std::string values_allowed_by(const WordRow& row) {
    if (row.modulo != 0) return "a rest by " + std::to_string(row.modulo) + " of " + either_of(row.values);
    if (!row.values.empty()) return either_of(row.values);
    std::string least = (row.above_least ? "more than " : "at least ") + number_word(row.least);
    const std::string most = (row.below_most ? "less than " : "at most ") + number_word(row.most);
    if (!std::isfinite(row.most)) return least;
    return std::isfinite(row.least) ? least + " and " + most : most;
}

bool takes(const WordRow& row, double value) {
    if (row.modulo != 0) value = std::fmod(value, row.modulo);
    if (!row.values.empty()) return has_word(row.values, number_word(value));
    const bool enough = row.above_least ? value > row.least : value >= row.least;
    return enough && (row.below_most ? value < row.most : value <= row.most);
}

std::string sections_in_words(std::string_view sections) {
    std::string names = all_of(sections);
    std::ranges::replace(names, '_', ' ');
    return names;
}

std::string partners_of(const WordRow& row) {
    std::string list;
    for (const std::string_view other : words_of(row.others)) {
        const std::string one = in_words(condition_of(other));
        list.append(list.empty() ? "" : " or ").append(one);
    }
    return list;
}

std::string code_of(const RowForCode& row) { return row.letter + number_word(row.code); }

std::string sentence_of(const RowForCode& row) {
    return condition_of(*row.row) + rule_in_words(row) + std::string(row.row->effect) + ".";
}

} // namespace maclint
