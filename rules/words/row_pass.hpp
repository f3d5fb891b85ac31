//! The rows' part in the pass over the words of a program.
#pragma once

#include "rules/words/row_index.hpp"
#include "rules/words/row_of_block.hpp"

#include <map>
#include <span>
#include <vector>

namespace maclint {

/// Whether the row of an arc's code wants its words in each block that goes on with it: in one that moves.
[[nodiscard]] inline bool goes_on_in_blocks(const WordRow& row) {
    return row.says == RowStatement::needs && !row.when.empty() && row.under.empty() && !row.kept;
}

/// Good for one program.
class RowPass {
  public:
    /// Rows of other rules are passed over.
    explicit RowPass(std::span<const Rule* const> rules);

    /// Looks at the rows of the codes that stand in the block.
    void look_at(const queries::WordsOfBlock& block, const RowIndex& index);
    /// Looks at the rows of a code of the group that is in force and that the block does not name. False:
    /// none of them holds.
    bool look_at_arc(const queries::WordsOfBlock& block, const RowIndex& index, GroupId group,
                     const queries::Mode& arc);
    [[nodiscard]] std::vector<Finding> take();

  private:
    void look_at(const queries::WordsOfBlock& block, const RowIndex& index, const RowIndex::Entry& entry,
                 const Word& code);

    std::map<const Rule*, Reporter> reporters_;
};

} // namespace maclint
