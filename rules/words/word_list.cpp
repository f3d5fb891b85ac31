//! Cuts lists at their blanks.
#include "rules/words/word_list.hpp"

#include <algorithm>
#include <charconv>

namespace maclint {

std::vector<std::string_view> words_of(std::string_view list) {
    std::vector<std::string_view> words;
    for (std::size_t begin = 0; begin < list.size();) {
        const std::size_t end = std::min(list.find(' ', begin), list.size());
        if (end > begin) words.push_back(list.substr(begin, end - begin));
        begin = end + 1;
    }
    return words;
}

bool has_word(std::string_view list, std::string_view word) {
    for (std::size_t begin = 0; begin < list.size();) {
        const std::size_t end = std::min(list.find(' ', begin), list.size());
        if (list.substr(begin, end - begin) == word) return true;
        begin = end + 1;
    }
    return false;
}

double code_number_of(std::string_view code) {
    double number = 0;
    std::from_chars(code.data() + 1, code.data() + code.size(), number);
    return number;
}

namespace {

std::string listed(std::string_view list, std::string_view last) {
    const std::vector<std::string_view> words = words_of(list);
    std::string text;
    for (std::size_t i = 0; i < words.size(); ++i)
        text.append(i == 0 ? "" : i + 1 == words.size() ? last : ", ").append(words[i]);
    return text;
}

} // namespace

std::string either_of(std::string_view list) { return listed(list, " or "); }

std::string all_of(std::string_view list) { return listed(list, " and "); }

} // namespace maclint
