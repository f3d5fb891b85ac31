//! The rows that can hold in a section of a control's programs, by their codes, and which blocks they want.
#pragma once

#include "analyzer/program/lines_with.hpp"
#include "analyzer/program/model.hpp"
#include "rules/words/rule_row.hpp"
#include "rules/words/words_of_codes.hpp"

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace maclint {

class RowIndex {
  public:
    /// A row under one of its codes, and the addresses that it names.
    struct Entry {
        const RuleRow* rule_row;
        const RowForCode* row;
        std::int64_t code;                ///< see code_number()
        syntax::AddressSet words, others; ///< those that surely are the row's
        syntax::AddressSet maybe_words,
            maybe_others; ///< and those that scanning does not tell apart from them

        /// Whether the row can be wrong in one of several blocks with its code: `any` are the addresses of
        /// all of them, `all` those that each holds.
        [[nodiscard]] bool can_be_wrong(syntax::AddressSet any, syntax::AddressSet all) const;
    };

    /// `tables`: how plain blocks of the programs are read; nullptr where there are none.
    RowIndex(const ControlModel& control, std::string_view section, const syntax::PlainTables* tables,
             std::span<const RuleRow* const> rows);

    [[nodiscard]] bool empty() const { return is_empty_; }
    /// The codes whose rows can be wrong in one of the run's blocks; those that are `idle` cannot.
    [[nodiscard]] std::vector<LetterCodes>
    codes_wanted(const Program& program, const PlainRun& run,
                 const std::function<bool(const WordRow&)>& idle) const;
    /// Whether a row can be wrong in a block of which this is known.
    [[nodiscard]] bool wants_block(const WordSummary& block) const;
    /// The rows of the code that the word is; none where it is none.
    [[nodiscard]] std::span<const Entry> rows_at(const Word& word) const;
    /// The rows of an address, whatever codes stand beside it.
    [[nodiscard]] std::span<const Entry> rows_at_address(const Word& word) const;
    /// Of the chapters, where these tell of the language's codes.
    [[nodiscard]] const WordsOfCodes& words_of_codes() const { return words_of_codes_; }

  private:
    bool is_empty_ = true;
    std::vector<Entry> entries_;         ///< by code
    std::vector<LetterCodes> all_codes_; ///< of all entries
    syntax::CodeSet codes_;              ///< the same
    std::array<std::vector<Entry>, syntax::CodeSet::capacity> by_kind_;
    WordsOfCodes words_of_codes_;
    std::array<std::vector<Entry>, 26> of_addresses_; ///< by capital letter
    syntax::AddressSet addresses_;                    ///< the same
};

} // namespace maclint
