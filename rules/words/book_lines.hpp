//! What the lines of chapters are written with.
#pragma once

#include "rules/words/code_book.hpp"
#include "rules/words/row_values.hpp"

#include <cstdint>

namespace maclint {

namespace book {

/// `codes`: "G83", or several that say the same.
constexpr BookLine code(TableText codes, std::uint32_t line, TableText means, TableText sections = {}) {
    return {BookLine::Kind::code,
            {.says = RowStatement::takes_only,
             .code = codes,
             .sections = sections,
             .means = means,
             .effect = {},
             .severity = Severity::warning,
             .source = {}},
            line};
}

/// `takes`: see set_values(); empty: any value.
constexpr BookLine word(TableText address, std::uint32_t line, TableText means, TableText takes = {}) {
    BookLine result{BookLine::Kind::word,
                    {.says = RowStatement::values,
                     .code = {},
                     .words = address,
                     .means = means,
                     .effect = {},
                     .severity = Severity::warning,
                     .source = {}},
                    line};
    set_values(result.row, takes);
    return result;
}

constexpr BookLine statement(RowStatement says, TableText words, TableText others, std::uint32_t line,
                             TableText means, TableText effect, Severity severity = Severity::warning) {
    return {BookLine::Kind::statement,
            {.says = says,
             .code = {},
             .words = words,
             .others = others,
             .means = means,
             .effect = effect,
             .severity = severity,
             .source = {}},
            line};
}

/// One of the words at least; `means`: what they are together.
constexpr BookLine needs(TableText words, std::uint32_t line, TableText means, TableText effect) {
    return statement(RowStatement::needs, words, {}, line, means, effect);
}
/// None of the words.
constexpr BookLine takes_not(TableText words, std::uint32_t line, TableText effect) {
    return statement(RowStatement::takes_not, words, {}, line, {}, effect);
}
/// One of the words or of the others, not both.
constexpr BookLine excludes(TableText words, TableText others, std::uint32_t line, TableText effect) {
    return statement(RowStatement::excludes, words, others, line, {}, effect);
}
/// The words beside one of the others only; "O=1" is one with that value, "Q=1|2" with one of several.
constexpr BookLine only_with(TableText words, TableText others, std::uint32_t line, TableText effect) {
    return statement(RowStatement::only_with, words, others, line, {}, effect);
}
/// A value under a condition (BookLine::when).
constexpr BookLine value(TableText word, TableText takes, std::uint32_t line, TableText effect) {
    BookLine result = statement(RowStatement::values, word, {}, line, {}, effect);
    set_values(result.row, takes);
    return result;
}
/// No word beside the code but these.
constexpr BookLine alone(TableText words, std::uint32_t line, TableText effect) {
    return statement(RowStatement::alone, words, {}, line, {}, effect);
}
/// Not in a block with one of these codes.
constexpr BookLine apart(TableText codes, std::uint32_t line, TableText effect) {
    return statement(RowStatement::apart, {}, codes, line, {}, effect);
}
/// The next block with a code of the same letter holds one of these.
constexpr BookLine precedes(TableText codes, std::uint32_t line, TableText effect) {
    return statement(RowStatement::precedes, {}, codes, line, {}, effect);
}
/// The next block with a code of the same letter holds another one than these.
constexpr BookLine not_before(TableText codes, std::uint32_t line, TableText effect) {
    return statement(RowStatement::precedes, codes, {}, line, {}, effect);
}

/// The words number no block of a contour with one of the codes; `right`: some that it may have.
constexpr BookLine names_none(TableText words, TableText codes, TableText right, std::uint32_t line,
                              TableText effect) {
    BookLine result = statement(RowStatement::names_none, words, codes, line, {}, effect);
    result.row.first_block = right;
    return result;
}
/// Not at all, under a condition (BookLine::while_off).
constexpr BookLine refused(std::uint32_t line, TableText effect) {
    return statement(RowStatement::refused, {}, {}, line, {}, effect);
}
/// The switch is off again when the program ends.
constexpr BookLine left_on(TableText name, std::uint32_t line, TableText effect) {
    return statement(RowStatement::left_on, {}, {}, line, {}, effect).while_on(name);
}

} // namespace book

} // namespace maclint
