//! A row of the table of words and a block in which it holds: what the checks of rows look at.
#pragma once

#include "analyzer/machine/switched.hpp"
#include "analyzer/queries/modal/modes_at.hpp"
#include "analyzer/queries/words/block_words.hpp"
#include "rules/reporter.hpp"
#include "rules/words/rule_row.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace maclint {

class RowIndex;

/// Good as long as the check runs.
struct RowOfBlock {
    const queries::WordsOfBlock& block;
    const RowIndex& index;
    const RuleRow& rule_row;
    const RowForCode& of_code;
    const Word& code;  ///< the word of the block that is the row's code, or has its address
    std::string under; ///< the code of WordRow::under that is in force; empty where the row names none
    /// The block does not name the code, which is in force: where that was set. `code` has the bytes of a
    /// word that goes on with it.
    const queries::Mode* goes_on = nullptr;
    machine::Switched switched = {}; ///< the switch that the row names

    [[nodiscard]] const WordRow& row() const { return *of_code.row; }
    /// The first word of the block, other than the code, that has one of the addresses, with a value or
    /// without (MAC109 speaks of that); nullptr: none has.
    [[nodiscard]] const Word* find(std::string_view addresses) const;
    /// The words with one of the addresses and a value that surely belong to the code, in the order of the
    /// text.
    [[nodiscard]] std::vector<const Word*> own(std::string_view addresses) const;
    /// The row is of an address, whatever codes stand beside it; `code` is its word.
    [[nodiscard]] bool is_of_address() const { return of_code.is_of_address(); }
    /// Whether any block takes the word, whatever its codes.
    [[nodiscard]] bool is_taken_anywhere(const Word& word) const;
    /// Whether a word may belong to another code of the block.
    [[nodiscard]] bool may_belong_to_another(const Word& word) const;
    /// Whether a code that is in force may take the word: a cycle, a move.
    [[nodiscard]] bool may_go_on_to(const Word& word) const;
    /// "G40", as rows name codes, of a word whose value is written; empty for a word that is no code.
    [[nodiscard]] static std::string code_of(const Word& word);
    /// The bytes of the word, for a message.
    [[nodiscard]] std::string text_of(const Word& word) const;

    /// Reports the row at a word of the block: with its severity and the alarm of the control.
    Finding& report(Reporter& reporter, const Word& word, std::string_view message_id,
                    std::vector<std::string> arguments) const;
};

} // namespace maclint
