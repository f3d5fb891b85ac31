//! Reads conditions and holds them against words.
#include "analyzer/program/word_condition.hpp"

#include <charconv>
#include <variant>

namespace maclint {
namespace {

Fits fits(const Word& word, const WordCondition& condition) {
    if (condition.values.empty()) return Fits::yes;
    if (condition.above || condition.below) {
        const auto* literal = std::get_if<Literal>(&word.value);
        if (literal == nullptr) return Fits::unknown;
        double bound = 0;
        std::from_chars(condition.values.data(), condition.values.data() + condition.values.size(), bound);
        return (condition.above ? literal->value > bound : literal->value < bound) ? Fits::yes : Fits::no;
    }
    const Fits has = fits(word, condition.values);
    if (has == Fits::unknown || !condition.others) return has;
    return has == Fits::yes ? Fits::no : Fits::yes;
}

/// Of several words with the address one must fit.
Fits fits(std::span<const Word> words, const Word& code, const WordCondition& condition) {
    bool is_there = false;
    Fits best = Fits::no;
    for (const Word& word : words) {
        if (&word == &code || word.address != condition.address) continue;
        is_there = true;
        const Fits one = condition.there ? fits(word, condition) : Fits::no;
        if (one == Fits::yes || (one == Fits::unknown && best == Fits::no)) best = one;
    }
    if (is_there) return best;
    return !condition.there || condition.or_missing ? Fits::yes : Fits::no;
}

} // namespace

WordCondition condition_of(std::string_view text) {
    WordCondition condition;
    condition.there = !text.starts_with('-');
    if (!condition.there) text.remove_prefix(1);
    const std::size_t sign = text.find_first_of("=?!<>");
    condition.address = text.substr(0, sign);
    if (sign == std::string_view::npos) return condition;
    condition.or_missing = text[sign] == '?';
    condition.others = text[sign] == '!';
    condition.above = text[sign] == '>';
    condition.below = text[sign] == '<';
    condition.values = text.substr(sign + 1);
    return condition;
}

Fits fits(const Word& word, std::string_view values) {
    const auto* literal = std::get_if<Literal>(&word.value);
    if (literal == nullptr) return Fits::unknown;
    bool found = false;
    for_each_part(values, '|', [&](std::string_view value) {
        double number = 0;
        std::from_chars(value.data(), value.data() + value.size(), number);
        found |= number == literal->value;
    });
    return found ? Fits::yes : Fits::no;
}

Fits fits_beside(std::span<const Word> words, const Word& code, std::string_view conditions) {
    Fits all = Fits::yes;
    for_each_part(conditions, ' ', [&](std::string_view condition) {
        const Fits one = fits(words, code, condition_of(condition));
        if (all == Fits::no || one == Fits::no)
            all = Fits::no;
        else if (one == Fits::unknown)
            all = Fits::unknown;
    });
    return all;
}

} // namespace maclint
