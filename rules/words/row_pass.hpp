//! The rows' part in the pass over the words of a program.
#pragma once

#include "analyzer/queries/modes_at.hpp"
#include "rules/words/row_index.hpp"
#include "rules/words/row_of_block.hpp"

#include <map>
#include <span>
#include <string>
#include <vector>

namespace maclint {

/// Good for one program.
class RowPass {
  public:
    /// Rows of other rules are passed over.
    RowPass(const ProgramAnalysis& analysis, std::span<const Rule* const> rules);

    /// Looks at the rows of the codes that stand in the block.
    void look_at(const queries::WordsOfBlock& block, const RowIndex& index);
    [[nodiscard]] std::vector<Finding> take();

  private:
    void look_at(const queries::WordsOfBlock& block, const RowIndex::Entry& entry, const Word& code);
    /// Whether nothing is left of the words of a block before: the code's group was surely cancelled.
    [[nodiscard]] bool is_first_of_its_kind(const BlockView& block, const RowForCode& row);
    /// The codes of WordRow::under of which one is surely in force in the block, "G41 or G42"; empty: none
    /// is.
    [[nodiscard]] std::string in_force(const BlockView& block, const WordRow& row);

    const ProgramAnalysis& analysis_;
    queries::ModesAt modes_at_;
    std::map<const Rule*, Reporter> reporters_;
};

} // namespace maclint
