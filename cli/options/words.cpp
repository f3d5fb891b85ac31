//! Refusals with the words that are known.
#include "cli/options/words.hpp"

#include "analyzer/source/read.hpp"
#include "cli/config/configuration.hpp"
#include "cli/config/rule_words.hpp"
#include "cli/text/guess.hpp"
#include "cli/text/letters.hpp"
#include "rules/listed.hpp"

#include <utility>

namespace maclint::cli {

void refuse(std::string message) { throw Refused{std::move(message)}; }

void refuse_word(std::string_view option, const std::string& word, const std::vector<std::string>& known) {
    refuse(std::string(option) + " does not know '" + word + "'." +
           did_you_mean(word, known, "Known are " + rules::listed(known, " and ") + "."));
}

std::uintmax_t size_in_bytes(std::string_view option, const std::string& word) {
    constexpr std::string_view units = "kmg";
    std::uintmax_t size = 0;
    const char* const end_of_word = word.data() + word.size();
    const auto [end, error] = std::from_chars(word.data(), end_of_word, size);
    std::string unit = in_lower_case({end, static_cast<std::size_t>(end_of_word - end)});
    if (unit.starts_with(' ')) unit.erase(0, 1);
    const auto power = unit.empty() ? std::string_view::npos : units.find(unit.front());
    bool known = error == std::errc{};
    if (power != std::string_view::npos) {
        for (std::size_t i = 0; i <= power && size <= largest_source; ++i) size *= 1024;
        unit.erase(0, 1);
        known = known && (unit.empty() || unit == "b" || unit == "ib");
    } else {
        known = known && (unit.empty() || unit == "b");
    }
    if (!known || size == 0 || size > largest_source)
        refuse(std::string(option) + " does not take '" + word +
               "'. Give a size of 1 byte or more and less than 4G, for instance 500M or 2G.");
    return size;
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

std::vector<std::string> exemption_words() {
    std::vector<std::string> words;
    for (const NamedExemption& exemption : all_exemptions()) words.push_back(exemption.name());
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
            refuse(std::string(option) + " names no rule: '" + word + "'." + advice_for(word));
}

} // namespace maclint::cli
