//! Names addresses and values.
#include "rules/words/row_condition.hpp"

#include "rules/words/word_list.hpp"

#include <algorithm>

namespace maclint {

std::string in_words(const WordCondition& condition) {
    std::string address(condition.address);
    if (!condition.there) return "no " + address;
    if (condition.values.empty()) return address;
    if (condition.above || condition.below)
        return address + (condition.above ? " above " : " below ") + std::string(condition.values);
    std::string values(condition.values);
    std::ranges::replace(values, '|', ' ');
    return (condition.or_missing ? "no " + address + " or " : "") + address +
           (condition.others ? " other than " : " of ") + either_of(values);
}

std::string_view fitting_value(const WordCondition& condition) {
    if (condition.below) return "0";
    if (condition.above) return "9999";
    return condition.others ? std::string_view() : condition.values.substr(0, condition.values.find('|'));
}

std::string conditions_in_words(std::string_view conditions) {
    std::string text;
    for (const std::string_view condition : words_of(conditions))
        text += (text.empty() ? "With " : " and ") + in_words(condition_of(condition));
    return text;
}

} // namespace maclint
