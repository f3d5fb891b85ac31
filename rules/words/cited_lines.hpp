//! What the lines of chapters are written with where there is no manual whose lines could be counted: each
//! names its source by a key.
#pragma once

#include "rules/words/book_lines.hpp"

#include <string_view>

namespace maclint::book {

constexpr BookLine code(std::string_view codes, std::string_view source, std::string_view means,
                        std::string_view sections = {}) {
    return code(codes, 0U, means, sections).from(source);
}
constexpr BookLine word(std::string_view address, std::string_view source, std::string_view means,
                        std::string_view takes = {}) {
    return word(address, 0U, means, takes).from(source);
}
constexpr BookLine needs(std::string_view words, std::string_view source, std::string_view means,
                         std::string_view effect) {
    return needs(words, 0U, means, effect).from(source);
}
constexpr BookLine takes_not(std::string_view words, std::string_view source, std::string_view effect) {
    return takes_not(words, 0U, effect).from(source);
}
constexpr BookLine excludes(std::string_view words, std::string_view others, std::string_view source,
                            std::string_view effect) {
    return excludes(words, others, 0U, effect).from(source);
}
constexpr BookLine only_with(std::string_view words, std::string_view others, std::string_view source,
                             std::string_view effect) {
    return only_with(words, others, 0U, effect).from(source);
}
constexpr BookLine value(std::string_view word, std::string_view takes, std::string_view source,
                         std::string_view effect) {
    return value(word, takes, 0U, effect).from(source);
}
constexpr BookLine alone(std::string_view words, std::string_view source, std::string_view effect) {
    return alone(words, 0U, effect).from(source);
}
constexpr BookLine apart(std::string_view codes, std::string_view source, std::string_view effect) {
    return apart(codes, 0U, effect).from(source);
}
/// The words are written without a point.
constexpr BookLine whole(std::string_view words, std::string_view source, std::string_view effect) {
    return statement(RowStatement::whole, words, {}, 0U, {}, effect).from(source);
}
/// So many of the words at most.
constexpr BookLine at_most(double count, std::string_view words, std::string_view source,
                           std::string_view effect) {
    BookLine line = statement(RowStatement::at_most, words, {}, 0U, {}, effect).from(source);
    line.row.most = count;
    return line;
}
/// From the code up to one of `codes` stand no words but these.
constexpr BookLine until(std::string_view codes, std::string_view words, std::string_view source,
                         std::string_view effect) {
    return statement(RowStatement::until, words, codes, 0U, {}, effect).from(source);
}
/// Two words number the first and the last of some blocks: the first holds one of `begins_with`, none holds
/// one of `without`.
constexpr BookLine encloses(std::string_view words, std::string_view begins_with, std::string_view without,
                            std::string_view source, std::string_view effect) {
    BookLine line = statement(RowStatement::encloses, words, without, 0U, {}, effect).from(source);
    line.row.first_block = begins_with;
    return line;
}
/// Not while one of these codes is in force.
constexpr BookLine refused_under(std::string_view codes, std::string_view source, std::string_view effect) {
    return statement(RowStatement::refused, {}, {}, 0U, {}, effect).under(codes).from(source);
}

} // namespace maclint::book
