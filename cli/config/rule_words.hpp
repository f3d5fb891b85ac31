//! From words to the rules and rows of rules that they name.
#pragma once

#include "rules/rule.hpp"
#include "rules/words/rule_row.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace maclint::cli {

/// A rule with all of its rows, or one row alone.
struct NamedRule {
    const Rule* rule;
    const RuleRow* row = nullptr; ///< nullptr: all that the rule has

    friend bool operator==(const NamedRule&, const NamedRule&) = default;
};

/// What a word names: a code, an alias or a name in any case, a prefix of codes ("MAC3"), ALL; one of these
/// with the key of a row behind it ("MAC523/G83.Q", "word-missing/G83.Q"), or an alias of rows. Empty:
/// nothing.
[[nodiscard]] std::vector<NamedRule> rules_named(std::string_view word);

/// That, or what somebody may mean by a part of a code, a name or a key: "220", "jump", "G83".
[[nodiscard]] std::vector<NamedRule> rules_meant(std::string_view word);

/// Rules whose summary holds all of the words, in any case: "dwell time". None for words of one or two
/// letters.
[[nodiscard]] std::vector<NamedRule> rules_about(std::string_view words);

/// What names the finding's rule, and the row that found it: "MAC303", "MAC523/G83.Q".
[[nodiscard]] std::string code_with_key(const Finding& finding);
/// The same with the rule's name: "word-missing/G83.Q".
[[nodiscard]] std::string name_with_key(const Finding& finding);

/// Codes and names.
[[nodiscard]] const std::vector<std::string>& rule_words();
/// Codes with the keys of rows behind them: "MAC523/G83.Q".
[[nodiscard]] const std::vector<std::string>& row_words();

/// The words that a mistyped one most likely stands for, the likeliest first; a few at most.
[[nodiscard]] std::vector<std::string> rules_like(std::string_view word);
/// " Did you mean 'MAC523/G83.Q'?", or where to look.
[[nodiscard]] std::string advice_for(std::string_view word);

} // namespace maclint::cli
