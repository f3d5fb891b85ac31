//! A block with a code, and words beside it as its rows want them.
#pragma once

#include "rules/words/example_words.hpp"
#include "rules/words/rule_row.hpp"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace maclint {

/// Writes blocks with one code in one section: such as keep all rows, or all but one.
class ExampleBlock {
  public:
    /// `section`: its name with '_' for blanks; empty where sections do not matter.
    ExampleBlock(const ControlModel& control, std::string_view code, std::string_view section);

    /// "G83 X10. Q5.", without the end of its line; nullptr: it keeps every row.
    [[nodiscard]] std::string text(const WordRow* broken = nullptr) const;
    /// The row on the block after that holds for the words of `text(broken)`; nullptr: there is none.
    [[nodiscard]] const WordRow* order(const WordRow* broken = nullptr) const;
    /// The row on the blocks that the code encloses; nullptr: it encloses none.
    [[nodiscard]] const WordRow* enclosed() const;
    /// The row on the blocks after, whose data the code begins; nullptr: it begins none.
    [[nodiscard]] const WordRow* begun_data(const WordRow* broken = nullptr) const;
    /// All rows of the code there.
    [[nodiscard]] std::span<const WordRow* const> rows() const { return rows_; }
    /// As `text()`, for the row: with the words that it is about.
    [[nodiscard]] std::string text_that_keeps(const WordRow& row) const;

  private:
    [[nodiscard]] ExampleWords words(const WordRow* about, bool kept) const;
    void begin_with(ExampleWords& words, const WordRow& row, bool kept) const;
    bool mend(ExampleWords& words, const WordRow& row, std::string_view avoided) const;
    [[nodiscard]] bool forbids(const ExampleWords& words, std::string_view address) const;
    void add(ExampleWords& words, std::string_view address) const;
    [[nodiscard]] std::string value_of(std::string_view address) const;
    [[nodiscard]] std::string foreign_word() const;
    [[nodiscard]] std::string written(const ExampleWords& words) const;

    const ControlModel& control_;
    std::string code_;
    std::vector<const WordRow*> rows_; ///< of the code
};

/// "G83", "G41" of "G41 G42".
[[nodiscard]] std::string_view first_of(std::string_view list);

} // namespace maclint
