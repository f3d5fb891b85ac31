//! Beginnings and whole words first, for who remembers a part; edit distance then, for who mistypes.
#include "cli/text/guess.hpp"

#include "cli/text/letters.hpp"
#include "rules/listed.hpp"

#include <algorithm>
#include <cstddef>

namespace maclint::cli {
namespace {

constexpr std::size_t most_guesses = 3;
constexpr std::size_t least_part = 3;    ///< letters of a part that says anything
constexpr std::size_t longest_word = 64; ///< nobody mistypes a rule into more than that

/// Insertions, deletions, replacements and swapped neighbours that turn one word into the other.
std::size_t distance(std::string_view a, std::string_view b) {
    std::vector<std::vector<std::size_t>> table(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
    for (std::size_t i = 0; i <= a.size(); ++i) {
        for (std::size_t j = 0; j <= b.size(); ++j) {
            if (i == 0 || j == 0) {
                table[i][j] = i + j;
                continue;
            }
            const std::size_t replaced = table[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
            table[i][j] = std::min({table[i - 1][j] + 1, table[i][j - 1] + 1, replaced});
            const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
            if (swapped) table[i][j] = std::min(table[i][j], table[i - 2][j - 2] + 1);
        }
    }
    return table[a.size()][b.size()];
}

/// Without what options begin with, in lower case.
std::string compared(std::string_view word) {
    return in_lower_case(word.substr(std::min(word.find_first_not_of('-'), word.size())));
}

/// Whether the part is one or several whole words of the name: "loop" of "jump-into-loop".
bool has_words(std::string_view name, std::string_view part) {
    constexpr std::string_view between = "-/.";
    const auto ends = [&](std::size_t at) {
        return at == std::string_view::npos || at >= name.size() ||
               between.find(name[at]) != std::string_view::npos;
    };
    for (std::size_t at = name.find(part); at != std::string_view::npos; at = name.find(part, at + 1))
        if ((at == 0 || ends(at - 1)) && ends(at + part.size())) return true;
    return false;
}

/// "stats" of "statistics": it begins with the same letters, and the others follow in their order.
bool is_short_for(std::string_view part, std::string_view name) {
    if (part.substr(0, least_part) != name.substr(0, least_part)) return false;
    std::size_t at = 0;
    for (const char c : name)
        if (at < part.size() && part[at] == c) ++at;
    return at == part.size();
}

/// Whether the name only adds words to the other: "fanuc-0i-d-lathe" to "fanuc-0i-d".
bool adds_words(std::string_view name, std::string_view other) {
    return name.starts_with(other) && name.substr(other.size()).starts_with('-');
}

/// Those that `is_like` takes; none where they are so many that naming a few would mislead.
template<class IsLike>
std::vector<std::string> those(std::span<const std::string> candidates, const IsLike& is_like) {
    std::vector<std::string> found;
    for (const std::string& candidate : candidates) {
        const auto adds = [&](const std::string& other) { return adds_words(candidate, other); };
        if (!is_like(compared(candidate)) || std::ranges::any_of(found, adds)) continue;
        if (found.size() == most_guesses) return {};
        found.push_back(candidate);
    }
    return found;
}

} // namespace

std::optional<std::string> closest(std::string_view word, std::span<const std::string> candidates) {
    if (word.empty() || word.size() > longest_word) return std::nullopt;
    const std::string given = in_lower_case(word);
    const std::string* best = nullptr;
    // Codes differ in single digits: two wrong ones make another code, not a mistyped one.
    const bool has_digit = given.find_first_of("0123456789") != std::string::npos;
    std::size_t least = (has_digit ? 1 : std::max<std::size_t>(1, given.size() / 3)) + 1;
    for (const std::string& candidate : candidates) {
        // As many letters as one of them is longer are wrong at least.
        if (candidate.size() >= given.size() + least || given.size() >= candidate.size() + least) continue;
        const std::size_t apart = distance(given, in_lower_case(candidate));
        if (apart >= least || apart >= candidate.size()) continue;
        least = apart;
        best = &candidate;
    }
    return best == nullptr ? std::nullopt : std::optional(*best);
}

std::vector<std::string> likely(std::string_view word, std::span<const std::string> candidates) {
    const std::string given = compared(word);
    if (given.size() >= least_part && given.size() <= longest_word) {
        for (const auto& found :
             {those(candidates, [&](const std::string& name) { return name.starts_with(given); }),
              those(candidates, [&](const std::string& name) { return is_short_for(given, name); }),
              those(candidates, [&](const std::string& name) { return has_words(name, given); })})
            if (!found.empty()) return found;
    }
    if (const auto nearest = closest(word, candidates)) return {*nearest};
    return those(candidates, [&](const std::string& name) {
        const auto is_longer = [&](const std::string& other) { return adds_words(compared(other), name); };
        return name.size() >= least_part && given.size() <= longest_word && given.starts_with(name) &&
               std::ranges::none_of(candidates, is_longer);
    });
}

std::string meant(const std::vector<std::string>& words) {
    std::vector<std::string> quoted;
    for (const std::string& word : words) quoted.push_back("'" + word + "'");
    return " Did you mean " + rules::listed(quoted, " or ") + "?";
}

std::string did_you_mean(std::string_view word, std::span<const std::string> candidates,
                         std::string_view otherwise) {
    const auto found = likely(word, candidates);
    return found.empty() ? " " + std::string(otherwise) : meant(found);
}

} // namespace maclint::cli
