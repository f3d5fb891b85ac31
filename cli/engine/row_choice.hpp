//! Which rows of rules run: chosen once for all files of a run.
#pragma once

#include "cli/config/rule_words.hpp"
#include "cli/engine/snapshot.hpp"

#include <memory>
#include <vector>

namespace maclint::cli {

/// What is made of rows serves all programs of a control, so that programs have no choices of their own: each
/// file drops what it did not want.
class RowChoice {
  public:
    explicit RowChoice(const Snapshot& snapshot);

    /// Whether it is among those that some file wants; of a rule all its rows.
    [[nodiscard]] bool wants(const NamedRule& named) const;
    /// Those that some file wants.
    [[nodiscard]] const std::shared_ptr<const RowIndexes>& wanted() const { return wanted_; }
    /// All of them, for groups in which a comment allows what no file wants.
    [[nodiscard]] const std::shared_ptr<const RowIndexes>& all() const { return all_; }

  private:
    std::vector<bool> is_wanted_; ///< by a file that was asked for, in the order of all_rule_rows()
    std::shared_ptr<const RowIndexes> wanted_;
    std::shared_ptr<const RowIndexes> all_;
};

} // namespace maclint::cli
