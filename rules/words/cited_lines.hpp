//! What the lines of chapters are written with where there is no manual whose lines could be counted: each
//! names its source by a key.
#pragma once

#include "rules/words/book_lines.hpp"

namespace maclint::book {

constexpr BookLine code(TableText codes, TableText source, TableText means, TableText sections = {}) {
    return code(codes, 0U, means, sections).from(source);
}
constexpr BookLine word(TableText address, TableText source, TableText means, TableText takes = {}) {
    return word(address, 0U, means, takes).from(source);
}
constexpr BookLine needs(TableText words, TableText source, TableText means, TableText effect) {
    return needs(words, 0U, means, effect).from(source);
}
constexpr BookLine takes_not(TableText words, TableText source, TableText effect) {
    return takes_not(words, 0U, effect).from(source);
}
constexpr BookLine excludes(TableText words, TableText others, TableText source, TableText effect) {
    return excludes(words, others, 0U, effect).from(source);
}
constexpr BookLine only_with(TableText words, TableText others, TableText source, TableText effect) {
    return only_with(words, others, 0U, effect).from(source);
}
constexpr BookLine value(TableText word, TableText takes, TableText source, TableText effect) {
    return value(word, takes, 0U, effect).from(source);
}
constexpr BookLine alone(TableText words, TableText source, TableText effect) {
    return alone(words, 0U, effect).from(source);
}
constexpr BookLine apart(TableText codes, TableText source, TableText effect) {
    return apart(codes, 0U, effect).from(source);
}
/// The words are written without a point.
constexpr BookLine whole(TableText words, TableText source, TableText effect) {
    return statement(RowStatement::whole, words, {}, 0U, {}, effect).from(source);
}
/// So many of the words at most.
constexpr BookLine at_most(double count, TableText words, TableText source, TableText effect) {
    BookLine line = statement(RowStatement::at_most, words, {}, 0U, {}, effect).from(source);
    line.row.most = count;
    return line;
}
/// From the code up to one of `codes` stand no words but these.
constexpr BookLine until(TableText codes, TableText words, TableText source, TableText effect) {
    return statement(RowStatement::until, words, codes, 0U, {}, effect).from(source);
}
/// Two words number the first and the last of some blocks: the first holds one of `begins_with`, none holds
/// one of `without`.
constexpr BookLine encloses(TableText words, TableText begins_with, TableText without, TableText source,
                            TableText effect) {
    BookLine line = statement(RowStatement::encloses, words, without, 0U, {}, effect).from(source);
    line.row.first_block = begins_with;
    return line;
}
/// Not while one of these codes is in force.
constexpr BookLine refused_under(TableText codes, TableText source, TableText effect) {
    return statement(RowStatement::refused, {}, {}, 0U, {}, effect).under(codes).from(source);
}

} // namespace maclint::book
