//! Codes, names and keys are compared in capitals.
#include "cli/config/rule_words.hpp"

#include "cli/text/guess.hpp"
#include "cli/text/letters.hpp"
#include "rules/words/word_list.hpp"

#include <algorithm>
#include <cctype>
#include <iterator>
#include <optional>
#include <unordered_map>
#include <utility>

namespace maclint::cli {
namespace {

constexpr std::size_t most_proposals = 3;

bool has_digit(std::string_view text) {
    return std::ranges::any_of(text, [](unsigned char c) { return std::isdigit(c) != 0; });
}

/// "MAC", "MAC3" and "MAC30" are prefixes; "M" and "JUMP" are not.
bool is_prefix(std::string_view word) {
    constexpr std::string_view families[] = {"MAC", "DIN", "SIN"};
    return std::ranges::any_of(families, [&](std::string_view family) {
        return word == family || (word.starts_with(family) && has_digit(word));
    });
}

/// Several codes of one row have a key each, and its aliases in common.
std::vector<NamedRule> rows_with_alias(std::string_view capitals) {
    using Rows = std::unordered_map<std::string, std::vector<NamedRule>>;
    static const Rows rows = [] {
        Rows all;
        for (const RuleRow& row : all_rule_rows())
            for (const RowForCode& one : row.rows)
                for (const std::string_view alias : words_of(one.row->aliases)) {
                    std::vector<NamedRule>& named = all[in_upper_case(alias)];
                    const NamedRule itself{row.rule, &row};
                    if (std::ranges::find(named, itself) == named.end()) named.push_back(itself);
                }
        return all;
    }();
    const auto found = rows.find(std::string(capitals));
    return found == rows.end() ? std::vector<NamedRule>() : found->second;
}

/// A word that names a row by its rule.
struct RowWord {
    std::string_view rule;
    std::string key; ///< in capitals
};

std::optional<RowWord> row_word(std::string_view word) {
    const std::size_t slash = word.find('/');
    if (slash == std::string_view::npos) return std::nullopt;
    return RowWord{word.substr(0, slash), in_upper_case(word.substr(slash + 1))};
}

template<class Wanted>
std::vector<NamedRule> rules_where(const Wanted& wanted) {
    std::vector<NamedRule> rules;
    for (const Rule* rule : all_rules())
        if (wanted(*rule)) rules.push_back({rule});
    return rules;
}

/// Rows of the code or key that is written: "G83", "G83.Q".
bool is_begun_by(const RuleRow& row, std::string_view key) {
    return !key.empty() && row.key.starts_with(key) &&
           (row.key.size() == key.size() ||
            std::isalnum(static_cast<unsigned char>(row.key[key.size()])) == 0);
}

template<class Rows>
std::vector<NamedRule> rows_begun_by(const Rows& rows, std::string_view key) {
    std::vector<NamedRule> named;
    for (const RuleRow& row : rows)
        if (is_begun_by(row, key)) named.push_back({row.rule, &row});
    return named;
}

std::vector<std::string> keys_of(std::span<const RuleRow> rows) {
    std::vector<std::string> keys;
    std::ranges::transform(rows, std::back_inserter(keys), &RuleRow::key);
    return keys;
}

/// Keys of the rule that are like the one written: of the same code, or mistyped.
std::vector<std::string> rows_like(const Rule& rule, const std::string& key) {
    const auto rows = rows_of(rule);
    if (rows.empty()) return {std::string(rule.code)};
    std::vector<std::string> names;
    if (const auto near = closest(key, keys_of(rows))) names.push_back(std::string(rule.code) + "/" + *near);
    for (const RuleRow& row : rows) {
        const bool same_code = is_begun_by(row, std::string_view(key).substr(0, key.find_first_of(".-")));
        if (same_code && std::ranges::find(names, row.name()) == names.end()) names.push_back(row.name());
    }
    return names;
}

/// Rows of this very key, of other rules than the one that was named.
std::vector<std::string> rows_with_key(const std::string& key) {
    std::vector<std::string> names;
    for (const RuleRow& row : all_rule_rows())
        if (row.key == key) names.push_back(row.name());
    return names;
}

std::vector<std::string> like_row(const RowWord& word) {
    const Rule* rule = find_rule(word.rule);
    if (rule == nullptr) {
        const auto near = closest(word.rule, rule_words());
        rule = near ? find_rule(*near) : nullptr;
        if (rule != nullptr && find_rule_row(*near + "/" + word.key) != nullptr)
            return {*near + "/" + word.key};
    }
    if (rule == nullptr) return rows_with_key(word.key);
    std::vector<std::string> names = rows_like(*rule, word.key);
    if (names.empty()) names = rows_with_key(word.key);
    return names;
}

} // namespace

std::vector<NamedRule> rules_named(std::string_view word) {
    if (const Rule* rule = find_rule(word)) return {{rule}};
    if (row_word(word)) {
        const RuleRow* row = find_rule_row(word);
        return row == nullptr ? std::vector<NamedRule>() : std::vector<NamedRule>{{row->rule, row}};
    }
    const std::string capitals = in_upper_case(word);
    if (capitals == "ALL") return rules_where([](const Rule&) { return true; });
    if (auto rows = rows_with_alias(capitals); !rows.empty()) return rows;
    if (!is_prefix(capitals)) return {};
    return rules_where([&](const Rule& rule) { return rule.code.starts_with(capitals); });
}

std::vector<NamedRule> rules_meant(std::string_view word) {
    std::vector<NamedRule> rules = rules_named(word);
    if (!rules.empty() || word.empty()) return rules;
    if (const auto row = row_word(word)) {
        const Rule* rule = find_rule(row->rule);
        return rule == nullptr ? rules : rows_begun_by(rows_of(*rule), row->key);
    }
    const std::string part = in_lower_case(word);
    const bool is_number = part.find_first_not_of("0123456789") == std::string::npos;
    rules = rules_where([&](const Rule& rule) {
        constexpr std::size_t letters = 3; // of a code
        return is_number ? rule.code.substr(letters).starts_with(part)
                         : rule.name.find(part) != std::string_view::npos;
    });
    std::ranges::copy(rows_begun_by(all_rule_rows(), in_upper_case(word)), std::back_inserter(rules));
    return rules;
}

std::vector<NamedRule> rules_about(std::string_view words) {
    constexpr std::size_t least_letters = 3;
    std::vector<std::string> wanted;
    for (const std::string_view word : maclint::words_of(words))
        if (word.size() >= least_letters) wanted.push_back(in_lower_case(word));
    if (wanted.empty()) return {};
    return rules_where([&](const Rule& rule) {
        const std::string summary = in_lower_case(rule.summary);
        return std::ranges::all_of(
            wanted, [&](const std::string& word) { return summary.find(word) != std::string::npos; });
    });
}

std::string code_with_key(const Finding& finding) {
    return finding.row == nullptr ? std::string(finding.rule->code) : finding.row->name();
}

std::string name_with_key(const Finding& finding) {
    return std::string(finding.rule->name) + (finding.row == nullptr ? "" : "/" + finding.row->key);
}

const std::vector<std::string>& rule_words() {
    static const std::vector<std::string> words = [] {
        std::vector<std::string> all;
        for (const Rule* rule : all_rules())
            all.insert(all.end(), {std::string(rule->code), std::string(rule->name)});
        return all;
    }();
    return words;
}

const std::vector<std::string>& row_words() {
    static const std::vector<std::string> words = [] {
        std::vector<std::string> all;
        std::ranges::transform(all_rule_rows(), std::back_inserter(all), &RuleRow::name);
        return all;
    }();
    return words;
}

std::vector<std::string> rules_like(std::string_view word) {
    std::vector<std::string> like;
    if (const auto row = row_word(word))
        like = like_row(*row);
    else
        like = likely(word, rule_words());
    if (like.size() > most_proposals) like.resize(most_proposals);
    return like;
}

std::string advice_for(std::string_view word) {
    const std::vector<std::string> like = rules_like(word);
    if (!like.empty()) return meant(like);
    const auto row = row_word(word);
    const Rule* rule = row ? find_rule(row->rule) : nullptr;
    if (rule != nullptr) return " See 'maclint explain " + std::string(rule->code) + "' for its rows.";
    return " See 'maclint rules' for the list.";
}

} // namespace maclint::cli
