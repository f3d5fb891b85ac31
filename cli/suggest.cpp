//! Edit distance, and lists in plain English.
#include "cli/suggest.hpp"

#include "analyzer/source/encoding.hpp"

#include <algorithm>
#include <cctype>

namespace maclint::cli {
namespace {

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

template<class Change>
std::string changed(std::string_view text, Change change) {
    std::string out(text);
    std::ranges::transform(out, out.begin(), [change](char c) {
        return static_cast<char>(change(static_cast<unsigned char>(c)));
    });
    return out;
}

} // namespace

std::string in_lower_case(std::string_view text) {
    return changed(text, [](int c) { return std::tolower(c); });
}

std::string in_upper_case(std::string_view text) {
    return changed(text, [](int c) { return std::toupper(c); });
}

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

std::string did_you_mean(std::string_view word, std::span<const std::string> candidates,
                         std::string_view otherwise) {
    if (const auto best = closest(word, candidates)) return " Did you mean '" + *best + "'?";
    return " " + std::string(otherwise);
}

std::string counted(std::size_t count, std::string_view noun) {
    return std::to_string(count) + " " + std::string(noun) + (count == 1 ? "" : "s");
}

std::string shown(std::string_view bytes) { return printable(to_utf8(bytes, detect_encoding(bytes))); }

} // namespace maclint::cli
