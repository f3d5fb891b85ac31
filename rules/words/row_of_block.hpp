//! A row of the table of words and a block in which it holds: what the checks of rows look at.
#pragma once

#include "analyzer/queries/block_words.hpp"
#include "rules/reporter.hpp"
#include "rules/words/rule_row.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace maclint {

/// Good as long as the check runs.
struct RowOfBlock {
    const queries::WordsOfBlock& block;
    const RuleRow& rule_row;
    const RowForCode& of_code;
    const Word& code;  ///< the word of the block that is the row's code
    std::string under; ///< the code of WordRow::under that is in force; empty where the row names none

    [[nodiscard]] const WordRow& row() const { return *of_code.row; }
    /// The first word of the block, other than the code, that has one of the addresses, with a value or
    /// without (MAC109 speaks of that); nullptr: none has.
    [[nodiscard]] const Word* find(std::string_view addresses) const;
    /// The words with one of the addresses and a value that surely belong to the code, in the order of the
    /// text.
    [[nodiscard]] std::vector<const Word*> own(std::string_view addresses) const;
    /// The bytes of the word, for a message.
    [[nodiscard]] std::string text_of(const Word& word) const;

    /// Reports the row at a word of the block: with its severity and the alarm of the control.
    Finding& report(Reporter& reporter, const Word& word, std::string_view message_id,
                    std::vector<std::string> arguments) const;
};

} // namespace maclint
