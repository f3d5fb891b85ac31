//! The values that a row takes, and how tables write them.
#pragma once

#include "rules/words/word_row.hpp"

#include <cstddef>
#include <limits>
#include <string_view>

namespace maclint {

inline constexpr double unbounded = std::numeric_limits<double>::infinity();

/// Reads a number and takes it off the text.
constexpr double take_number(std::string_view& text) {
    const bool negative = text.starts_with('-');
    if (negative) text.remove_prefix(1);
    double value = 0;
    double place = 0;
    std::size_t read = 0;
    for (; read < text.size() && ((text[read] >= '0' && text[read] <= '9') || text[read] == '.'); ++read) {
        if (text[read] == '.' && !text.substr(read).starts_with("..")) {
            place = 1;
            continue;
        }
        if (text[read] == '.') break;
        value = value * 10 + (text[read] - '0');
        place *= 10;
    }
    if (read == 0) throw "a number belongs here";
    text.remove_prefix(read);
    return (negative ? -value : value) / (place > 0 ? place : 1);
}

/// Sets the values that a word takes: "0 1 2", "1..127", ">0", ">=0", ">-60 <60". Anything else does not
/// compile.
constexpr void set_values(WordRow& row, TableText text) {
    std::string_view takes = text;
    if (takes.empty()) return;
    if (takes.find("..") == std::string_view::npos && takes.front() != '<' && takes.front() != '>') {
        row.values = text;
        return;
    }
    while (!takes.empty()) {
        const char sign = takes.front();
        if (sign == ' ') {
            takes.remove_prefix(1);
        } else if (sign == '<' || sign == '>') {
            takes.remove_prefix(1);
            const bool itself = takes.starts_with('=');
            if (itself) takes.remove_prefix(1);
            const double bound = take_number(takes);
            (sign == '>' ? row.least : row.most) = bound;
            (sign == '>' ? row.above_least : row.below_most) = !itself;
        } else {
            row.least = take_number(takes);
            if (!takes.starts_with("..")) throw "two full stops belong between bounds";
            takes.remove_prefix(2);
            row.most = take_number(takes);
        }
    }
}

/// Whether the row says anything of values.
[[nodiscard]] constexpr bool has_values(const WordRow& row) {
    return !row.values.empty() || row.least != -unbounded || row.most != unbounded;
}

constexpr void clear_values(WordRow& row) {
    row.values = {};
    row.least = -unbounded;
    row.most = unbounded;
    row.above_least = row.below_most = false;
}

} // namespace maclint
