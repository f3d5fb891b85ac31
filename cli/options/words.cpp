//! Refusals with the words that are known.
#include "cli/options/words.hpp"

#include "cli/config/configuration.hpp"
#include "cli/config/selection.hpp"
#include "cli/suggest.hpp"

#include <utility>

namespace maclint::cli {

void refuse(std::string message) { throw Refused{std::move(message)}; }

void refuse_word(std::string_view option, const std::string& word, const std::vector<std::string>& known) {
    refuse(std::string(option) + " does not know '" + word + "'." +
           did_you_mean(word, known, "Known are " + enumerate(known) + "."));
}

std::vector<std::string> split_at_commas(const std::vector<std::string>& lists) {
    std::vector<std::string> words;
    for (std::string_view list : lists) {
        while (!list.empty()) {
            const auto word = list.substr(0, list.find(','));
            if (!word.empty()) words.emplace_back(word);
            list.remove_prefix(word.size() == list.size() ? word.size() : word.size() + 1);
        }
    }
    return words;
}

std::vector<std::string> dialect_words() {
    auto words = dialect_names();
    words.insert(words.begin(), "auto");
    return words;
}

std::vector<std::string> severity_words() { return {"error", "warning", "note"}; }

std::vector<std::string> fail_on_words() {
    auto words = severity_words();
    words.emplace_back("never");
    return words;
}

void require_rules(std::string_view option, const std::vector<std::string>& words) {
    for (const std::string& word : words)
        if (rules_named(word).empty())
            refuse(std::string(option) + " names no rule: '" + word + "'." +
                   did_you_mean(word, rule_words(), "See 'maclint rules' for the list."));
}

} // namespace maclint::cli
