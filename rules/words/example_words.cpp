//! Looks for words and finds values.
#include "rules/words/example_words.hpp"

#include "rules/path.hpp"
#include "rules/words/row_condition.hpp"
#include "rules/words/row_text.hpp"
#include "rules/words/word_list.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace maclint {
namespace {

bool is_one_of(const std::string& written, std::string_view values) {
    std::string list(values);
    std::ranges::replace(list, '|', ' ');
    return values.empty() || has_word(list, written);
}

} // namespace

void ExampleWords::set(std::string_view address, std::string value) {
    for (auto& [there, written] : all_)
        if (there == address) {
            written = std::move(value);
            return;
        }
    add(address, std::move(value));
}

bool ExampleWords::stands(std::string_view addresses) const {
    return std::ranges::any_of(all_, [&](const auto& word) { return has_word(addresses, word.first); });
}

bool ExampleWords::holds(std::string_view conditions) const {
    return std::ranges::all_of(words_of(conditions), [&](std::string_view text) {
        const WordCondition condition = condition_of(text);
        const auto word =
            std::ranges::find_if(all_, [&](const auto& one) { return one.first == condition.address; });
        if (word == all_.end()) return !condition.there || condition.or_missing;
        return condition.there && is_one_of(word->second, condition.values) != condition.others;
    });
}

bool takes_written(const WordRow& row, const std::string& value) {
    double number = 0;
    std::from_chars(value.data(), value.data() + value.size(), number);
    return takes(row, number);
}

std::string allowed_value(const WordRow& row) {
    if (!row.values.empty()) return std::string(words_of(row.values).front());
    if (!std::isfinite(row.most)) return number_word(row.above_least ? row.least + 1 : row.least);
    if (!std::isfinite(row.least)) return number_word(row.most - 1);
    const double middle = (row.least + row.most) / 2;
    return number_word(std::floor(middle) > row.least ? std::floor(middle) : middle);
}

std::string refused_value(const WordRow& row) {
    if (!row.values.empty()) return "99999";
    if (std::isfinite(row.most)) return number_word(row.most + 1);
    return number_word(row.above_least ? row.least : row.least - 1);
}

} // namespace maclint
