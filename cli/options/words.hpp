//! What options say in words: choices, numbers, lists, and the answer to a word that is none of them.
#pragma once

#include <charconv>
#include <cstdint>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

namespace maclint::cli {

/// Thrown while texts are made into values, caught in read_command_line: "what. Cure."
struct Refused {
    std::string message;
};

[[noreturn]] void refuse(std::string message);
[[noreturn]] void refuse_word(std::string_view option, const std::string& word,
                              const std::vector<std::string>& known);

template<class Value>
struct Choice {
    std::string_view word;
    Value value;
};

template<class Choices>
std::vector<std::string> words_of(const Choices& choices) {
    std::vector<std::string> words;
    for (const auto& choice : choices) words.emplace_back(choice.word);
    return words;
}

template<class Choices>
auto choose(std::string_view option, const std::string& word, const Choices& choices) {
    for (const auto& choice : choices)
        if (choice.word == word) return choice.value;
    refuse_word(option, word, words_of(choices));
}

/// A whole number within the bounds.
template<class Number>
Number number(std::string_view option, const std::string& word, Number least, Number most) {
    Number value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc{} || end != word.data() + word.size() || value < least || value > most)
        refuse(std::string(option) + " does not take '" + word + "'. Give a whole number from " +
               std::to_string(least) + " to " + std::to_string(most) + ".");
    return value;
}

/// A size such as "500M", "2 GB" or "4096", in bytes; K, M and G are 1024 of what comes before. Less
/// than 4 GiB, as no larger program is read.
[[nodiscard]] std::uintmax_t size_in_bytes(std::string_view option, const std::string& word);

[[nodiscard]] std::vector<std::string> split_at_commas(const std::vector<std::string>& lists);

/// What --dialect and --fail-on take, and what severities are called.
[[nodiscard]] std::vector<std::string> dialect_words();
[[nodiscard]] std::vector<std::string> fail_on_words();
[[nodiscard]] std::vector<std::string> severity_words();

/// Names of all exemptions of rules: "MAC319/waits-for-others".
[[nodiscard]] std::vector<std::string> exemption_words();

/// Refuses words that name no rule.
void require_rules(std::string_view option, const std::vector<std::string>& words);

} // namespace maclint::cli
