//! A rule's rows by their keys: what users name beside the code, as in MAC523/G83.Q.
#pragma once

#include "rules/words/word_row.hpp"

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace maclint {

/// A row for one control or more, under one of its codes.
struct RowForCode {
    const WordTable* table;
    const WordRow* row;
    char letter; ///< 'G'; '*' of an address
    double code; ///< 83, 54.1

    /// The row is of an address, whatever codes stand beside it.
    [[nodiscard]] bool is_of_address() const { return letter == '*'; }
};

/// All rows of a rule that share a key: one for each control, or group of controls, that differs.
struct RuleRow {
    const Rule* rule;
    std::size_t index;            ///< in all_rule_rows()
    std::string key;              ///< "G83.Q"; capitals
    std::vector<RowForCode> rows; ///< one at least

    [[nodiscard]] const WordRow& first() const { return *rows.front().row; }
    /// "MAC523/G83.Q".
    [[nodiscard]] std::string name() const { return std::string(rule->code) + "/" + key; }
    [[nodiscard]] bool on_by_default() const { return rule->on_by_default && first().off_reason.empty(); }
};

/// Every row of every rule: the rules in their order, of each the keys in theirs.
[[nodiscard]] std::span<const RuleRow> all_rule_rows();
/// Those of one rule; empty for a rule without rows.
[[nodiscard]] std::span<const RuleRow> rows_of(const Rule& rule);
/// "MAC523/G83.Q", also with another name of the rule, small letters or zeros in front (G04.P). nullptr:
/// there is none.
[[nodiscard]] const RuleRow* find_rule_row(std::string_view name);
/// What the row says, a sentence: "G83 needs Q (depth of a peck); without it the hole is drilled in one
/// stroke."
[[nodiscard]] std::string sentence_of(const RowForCode& row);

} // namespace maclint
