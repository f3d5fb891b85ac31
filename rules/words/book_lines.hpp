//! What the lines of chapters are written with.
#pragma once

#include "rules/words/code_book.hpp"
#include "rules/words/row_values.hpp"

#include <cstdint>
#include <string_view>

namespace maclint {

namespace book {

/// `codes`: "G83", or several that say the same.
constexpr BookLine code(std::string_view codes, std::uint32_t line, std::string_view means,
                        std::string_view sections = {}) {
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
constexpr BookLine word(std::string_view address, std::uint32_t line, std::string_view means,
                        std::string_view takes = {}) {
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

constexpr BookLine statement(RowStatement says, std::string_view words, std::string_view others,
                             std::uint32_t line, std::string_view means, std::string_view effect,
                             Severity severity = Severity::warning) {
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
constexpr BookLine needs(std::string_view words, std::uint32_t line, std::string_view means,
                         std::string_view effect) {
    return statement(RowStatement::needs, words, {}, line, means, effect);
}
/// None of the words.
constexpr BookLine takes_not(std::string_view words, std::uint32_t line, std::string_view effect) {
    return statement(RowStatement::takes_not, words, {}, line, {}, effect);
}
/// One of the words or of the others, not both.
constexpr BookLine excludes(std::string_view words, std::string_view others, std::uint32_t line,
                            std::string_view effect) {
    return statement(RowStatement::excludes, words, others, line, {}, effect);
}
/// The words beside one of the others only; "O=1" is one with that value, "Q=1|2" with one of several.
constexpr BookLine only_with(std::string_view words, std::string_view others, std::uint32_t line,
                             std::string_view effect) {
    return statement(RowStatement::only_with, words, others, line, {}, effect);
}
/// A value under a condition (BookLine::when).
constexpr BookLine value(std::string_view word, std::string_view takes, std::uint32_t line,
                         std::string_view effect) {
    BookLine result = statement(RowStatement::values, word, {}, line, {}, effect);
    set_values(result.row, takes);
    return result;
}
/// No word beside the code but these.
constexpr BookLine alone(std::string_view words, std::uint32_t line, std::string_view effect) {
    return statement(RowStatement::alone, words, {}, line, {}, effect);
}
/// Not in a block with one of these codes.
constexpr BookLine apart(std::string_view codes, std::uint32_t line, std::string_view effect) {
    return statement(RowStatement::apart, {}, codes, line, {}, effect);
}
/// The next block with a code of the same letter holds one of these.
constexpr BookLine precedes(std::string_view codes, std::uint32_t line, std::string_view effect) {
    return statement(RowStatement::precedes, {}, codes, line, {}, effect);
}
/// The next block with a code of the same letter holds another one than these.
constexpr BookLine not_before(std::string_view codes, std::uint32_t line, std::string_view effect) {
    return statement(RowStatement::precedes, codes, {}, line, {}, effect);
}

} // namespace book

} // namespace maclint
